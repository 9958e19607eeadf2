// Hensel's notation: arrangements, hand-worked tables, errors.

#include <algorithm>
#include <bit>
#include <map>
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

/// The windows of background pixels that become foreground.
std::set<std::size_t> births(const std::string& notation) {
  const WindowTable table = table_from_hensel(notation);
  std::set<std::size_t> windows;
  for (std::size_t window = 0; window < WindowTable::kWindows; ++window) {
    if ((window & kCentre) == 0 && table[window]) windows.insert(window);
  }
  return windows;
}

std::size_t window_of(const std::string& pixels) {
  std::size_t window = 0;
  std::size_t bit = 1;
  for (const char pixel : pixels) {
    if (pixel == ' ') continue;
    if (pixel == '#') window |= bit;
    bit <<= 1;
  }
  return window;
}

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

TEST(Hensel, letters_divide_all_neighbourhoods_into_51_classes) {
  std::map<std::size_t, std::string> classes;
  for (const std::string& arrangement : arrangements()) {
    for (const std::size_t window : births("B" + arrangement + "/S")) {
      EXPECT_EQ(std::to_string(std::popcount(window)), arrangement.substr(0, 1));
      EXPECT_TRUE(classes.emplace(window, arrangement).second) << window << arrangement;
    }
  }
  EXPECT_EQ(classes.size(), 256U);
  EXPECT_EQ(arrangements().size(), 51U);
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
    for (const std::size_t window : births("B" + arrangement + "/S")) {
      const std::size_t index = (window & (kCentre - 1)) | (window >> 5 << 4);
      EXPECT_EQ(kLetters[index], arrangement.size() == 2 ? arrangement[1] : '.') << window;
    }
  }
}

TEST(Hensel, hand_worked_arrangements) {
  EXPECT_EQ(births("B2i/S"), (std::set{window_of("... #.# ..."), window_of(".#. ... .#.")}));
  EXPECT_EQ(births("B1c/S"), (std::set{window_of("#.. ... ..."), window_of("..# ... ..."),
                                       window_of("... ... #.."), window_of("... ... ..#")}));
  EXPECT_EQ(births("B4ce/S"), (std::set{window_of("#.# ... #.#"), window_of(".#. #.# .#.")}));
  EXPECT_EQ(births("B3i/S"), (std::set{window_of("### ... ..."), window_of("... ... ###"),
                                       window_of("#.. #.. #.."), window_of("..# ..# ..#")}));
  EXPECT_EQ(births("B7e/S"), (std::set{window_of("### #.# #.#"), window_of("#.# #.# ###"),
                                       window_of("### ..# ###"), window_of("### #.. ###")}));
}

TEST(Hensel, tlife_differs_from_life_in_two_arrangements) {
  const WindowTable life = table_from_hensel("B3/S23");
  const WindowTable tlife = table_from_hensel("B3/S2-i34q");
  std::set<std::size_t> differences;
  for (std::size_t window = 0; window < WindowTable::kWindows; ++window) {
    if (life[window] != tlife[window]) differences.insert(window);
  }
  std::set<std::size_t> expected = {window_of("... ### ..."), window_of(".#. .#. .#.")};
  for (const std::size_t window : births("B4q/S")) expected.insert(window | kCentre);
  EXPECT_EQ(differences, expected);
}

TEST(Hensel, rules_are_symmetric) {
  constexpr std::size_t kRotated[9] = {6, 3, 0, 7, 4, 1, 8, 5, 2};
  constexpr std::size_t kMirrored[9] = {2, 1, 0, 5, 4, 3, 8, 7, 6};
  for (const std::string& arrangement : arrangements()) {
    const WindowTable table = table_from_hensel("B/S" + arrangement);
    for (std::size_t window = 0; window < WindowTable::kWindows; ++window) {
      std::size_t rotated = 0;
      std::size_t mirrored = 0;
      for (std::size_t k = 0; k < 9; ++k) {
        rotated |= (window >> kRotated[k] & 1) << k;
        mirrored |= (window >> kMirrored[k] & 1) << k;
      }
      ASSERT_EQ(table[window], table[rotated]) << arrangement << window;
      ASSERT_EQ(table[window], table[mirrored]) << arrangement << window;
    }
  }
}

TEST(Hensel, excluded_letters_are_the_others) {
  EXPECT_EQ(births("B2-a/S"), births("B2cekin/S"));
  EXPECT_EQ(births("B4-cekainyqjrtwz/S"), std::set<std::size_t>{});
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
