// Hensel's notation: counts, the published letters, errors.
#include <algorithm>
#include <bit>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/rejection.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench {
namespace {

constexpr std::size_t kCentre = std::size_t{1} << WindowTable::kCentre;
const std::string kLettersOf[9] = {
    "", "ce", "cekain", "cekainyqjr", "cekainyqjrtwz", "cekainyqjr", "cekain", "ce", ""};

/// All letters with their number: 1c, 1e, 2c, ...
std::vector<std::string> arrangements() {
  std::vector<std::string> all = {"0", "8"};
  for (int count = 1; count <= 7; ++count) {
    for (const char letter : kLettersOf[count]) all.push_back(std::to_string(count) + letter);
  }
  return all;
}

TEST(Hensel, outer_totalistic_rules_count_neighbours) {
  struct Case {
    const char* notation;
    std::set<int> birth, survival;
  };
  for (const Case& one : {Case{"B3/S23", {3}, {2, 3}}, Case{"B36/S125", {3, 6}, {1, 2, 5}},
                          Case{"B0/S8", {0}, {8}}, Case{"B2/S", {2}, {}}, Case{"B/S", {}, {}},
                          Case{"B/S012345678", {}, {0, 1, 2, 3, 4, 5, 6, 7, 8}}}) {
    const WindowTable expected = make_window_table([&](std::size_t window) {
      const int neighbours = std::popcount(window & ~kCentre);
      return ((window & kCentre) != 0 ? one.survival : one.birth).contains(neighbours);
    });
    EXPECT_EQ(table_from_hensel(one.notation), expected) << one.notation;
  }
}

/// The letters of all neighbourhoods; bit i of the index is neighbour i in raster order. Compared
/// with two published lists.
constexpr std::string_view kLetters =
    ".ceaccaieaeaknjaekejanaairerririccknncqnaijaqnwakykkqyqjrtjnzrqa"
    "ekirkyrtejerkkjnekejjkrnejecjyccanriqyzraariqjqajkjywkqkrnccqknc"
    "cnkqccnnkqkqyykjaqjwinaarzjqtrnaccyyccyennkjyekenykknejeirykrike"
    "aqrznyirjwjqkkykaqrqajiarqcnnkccintrneriaanajekeajnkaeaeiaccaec.";

TEST(Hensel, letters_are_the_published_ones) {
  for (const std::string& arrangement : arrangements()) {
    const int count = arrangement[0] - '0';
    const char letter = arrangement.size() == 2 ? arrangement[1] : '.';
    const WindowTable expected = make_window_table([&](std::size_t window) {
      const std::size_t index = (window & (kCentre - 1)) | (window >> 5 << 4);
      return std::popcount(index) == count && kLetters[index] == letter;
    });
    EXPECT_EQ(table_from_hensel("B" + arrangement + "/S" + arrangement), expected) << arrangement;
  }
}

TEST(Hensel, excluded_letters_are_the_others) {
  EXPECT_EQ(table_from_hensel("B2-a/S"), table_from_hensel("B2cekin/S"));
  EXPECT_EQ(table_from_hensel("B4-cekainyqjrtwz/S"), WindowTable());
}

TEST(Hensel, order_slash_and_case_do_not_matter) {
  const WindowTable table = table_from_hensel("B2-a3k/S12n");
  for (const char* notation : {"S12n/B2-a3k", "b2-A3K/s12N", "B2-a3kS12n", "s12nb3K2-a"}) {
    EXPECT_EQ(table_from_hensel(notation), table) << notation;
  }
}

TEST(Hensel, errors_name_the_column_and_what_was_expected) {
  struct Case {
    std::string typed;
    int column;
    std::string expected;
  };
  for (const auto& [typed, column, expected] : std::vector<Case>{
           {"", 1, "expected B or S, got the end"},
           {"23/3", 1, "expected B or S, got '2'"},
           {"B3", 3, "expected S, got the end"},
           {"S23/S3", 5, "expected B, got 'S'"},
           {"B3/S2x", 6, "expected a letter of cekain after 2, got 'x'"},
           {"B3/S2y", 6, "expected a letter of cekain after 2, got 'y'"},
           {"B2{/S", 3, "expected S, got '{'"},
           {"B2\x7F/S", 3, "expected S, got '?'"},
           {"B0c/S", 3, "expected no letter after 0, got 'c'"},
           {"B8-/S", 4, "expected no letter after 8, got '/'"},
           {"B2-/S", 4, "expected a letter of cekain after 2, got '/'"},
           {"B9/S", 2, "expected a digit from 0 to 8, got '9'"},
           {"B33/S", 3, "3 is repeated"},
           {"B2-cekain2/S", 10, "2 is repeated"},
           {"B2aa/S", 4, "'a' is repeated"},
           {"B3/S23V", 7, "expected a letter of cekainyqjr after 3, got 'V'"},
           {"B3/S23/3", 7, "expected the end, got '/'"},
           {"B3\n/S", 3, "expected S, got '?'"},
           {"B3/S23" + std::string(1, '\0'), 7, "expected the end, got '?'"},
           {std::string(100000, 'B'), 257, "expected at most 256 characters, got 100000"}}) {
    const std::string text =
        rejection_of([&, notation = typed] { return table_from_hensel(notation); });
    EXPECT_EQ(text.rfind("rule '", 0), 0U) << text;
    EXPECT_TRUE(text.ends_with("', column " + std::to_string(column) + ": " + expected)) << text;
    EXPECT_TRUE(std::ranges::all_of(text, [](char c) { return c >= ' ' && c < '\x7F'; })) << text;
    EXPECT_LT(text.size(), 150U);
  }
}

}  // namespace
}  // namespace thinbench
