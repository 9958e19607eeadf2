// Notations of rules: those of Hensel, the patterns of Pillow, and tables in any order of pixels.
#include <algorithm>
#include <bit>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "rules/recorded_tables.hpp"
#include "support/rejection.hpp"
#include "thinbench/named_rules.hpp"
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

using Patterns = std::vector<std::string>;

TEST(Patterns, equal_the_tables_of_pillow) {
  const nlohmann::json tables = recorded().at("pillow").at("tables");
  ASSERT_EQ(tables.size(), 26U);
  for (const nlohmann::json& one : tables) {
    const auto patterns = one.at("patterns").get<Patterns>();
    EXPECT_EQ(table_from_patterns(patterns), recorded_table(one.at("table")))
        << one.at("patterns").dump();
  }
}

TEST(Patterns, whitespace_does_not_matter) {
  EXPECT_EQ(table_from_patterns(Patterns{" 4: (...\r\n   .1.\n\t111 ) -> 1\n"}),
            table_from_patterns(Patterns{"4:(....1.111)->1"}));
}

TEST(Patterns, errors_name_pattern_column_and_what_was_expected) {
  struct Case {
    const char* typed;
    int column;
    std::string expected;
  };
  const std::string pixel = "a pixel (0, 1, '.' or X), nine in all, got ";
  const auto error = [](const std::string& pattern) {
    return rejection_of([&] {
      return table_from_patterns(Patterns{"1:(... ... ...)->0", pattern});
    });
  };
  for (const auto& [typed, column, expected] :
       std::vector<Case>{{"", 1, "an operation: 1, 4, M or N, got the end"},
                         {"(... ... ...)->0", 1, "an operation: 1, 4, M or N, got '('"},
                         {"4m:(... ... ...)->0", 2, "an operation (1, 4, M or N) or ':', got 'm'"},
                         {"1:(... ... ..)->0", 14, pixel + "')'"},
                         {"1:(... ... ....)->0", 15, "')', got '.'"},
                         {"1:(... .2. ...)->0", 9, pixel + "'2'"},
                         {"1:(... ... ...)>0", 16, "'-', got '>'"},
                         {"1:(... ... ...)->2", 18, "the result, 0 or 1, got '2'"},
                         {"1:(... ... ...)->01", 19, "the end, got '1'"}}) {
    EXPECT_EQ(error(typed), std::string("pattern 2 '") + typed + "', column " +
                                std::to_string(column) + ": expected " + expected);
  }
  EXPECT_EQ(rejection_of([] { return table_from_patterns(Patterns(1001, "1:(.........)->0")); }),
            "expected at most 1000 patterns, got 1001");
  EXPECT_NE(error(std::string(1001, ' ')).find("expected at most 1000 characters, got 1001"),
            std::string::npos);
}

using Values = std::vector<std::uint8_t>;

/// 512 values that are 1 where bit `bit` of the index is.
Values values_of_bit(int bit) {
  Values values(512);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = static_cast<std::uint8_t>(i >> bit & 1);
  }
  return values;
}

WindowTable pixel_table(std::size_t k) {
  return make_window_table([k](std::size_t window) { return window >> k & 1; });
}

TEST(TableOrders, each_bit_is_one_pixel) {
  constexpr std::size_t kByColumns[] = {0, 3, 6, 1, 4, 7, 2, 5, 8};
  for (int bit = 0; bit < 9; ++bit) {
    const Values values = values_of_bit(bit);
    EXPECT_EQ(table_from_values(values, WindowOrder::raster),
              pixel_table(static_cast<std::size_t>(bit)));
    EXPECT_EQ(table_from_values(values, WindowOrder::matlab), pixel_table(kByColumns[bit]));
    EXPECT_EQ(table_from_values(values, WindowOrder::octave), pixel_table(kByColumns[8 - bit]));
  }
}

TEST(TableOrders, the_exceptions_of_hbreak_in_octaves_order) {
  Values values = values_of_bit(4);
  values[381] = values[471] = 0;  // as Octave's bwmorph writes them, from 1: 382 and 472
  const WindowTable hbreak = find_named_rule("hbreak")->sub_iterations.front();
  EXPECT_EQ(table_from_values(values, WindowOrder::octave), hbreak);
}

TEST(TableOrders, removals_name_the_neighbour_of_each_bit) {
  for (const NeighbourOrder& order : {kDescriptorOrder, kClockwiseOrder, kRasterOrder}) {
    for (std::size_t bit = 0; bit < 8; ++bit) {
      Values removed(256);
      for (std::size_t i = 0; i < 256; ++i) removed[i] = static_cast<std::uint8_t>(i >> bit & 1);
      const std::size_t pixel = order[bit];
      EXPECT_EQ(table_from_removals(removed, order), make_window_table([&](std::size_t window) {
                  return (window >> 4 & 1) != 0 && (window >> pixel & 1) == 0;
                }));
    }
  }
}

TEST(TableOrders, tables_of_scikit_image_are_those_of_its_rule) {
  const nlohmann::json digits = recorded().at("skimage").at("thin");
  const auto tables = find_named_rule("thin")->sub_iterations;
  ASSERT_EQ(tables.size(), digits.size());
  for (std::size_t sub = 0; sub < tables.size(); ++sub) {
    EXPECT_EQ(table_from_removals(bits_of(digits.at(sub)), kDescriptorOrder), tables[sub]);
  }
}

TEST(TableOrders, errors_name_size_position_and_value) {
  const auto error = [](const Values& values) {
    return rejection_of([&] { return table_from_values(values, WindowOrder::matlab); });
  };
  Values values(512);
  values[17] = 2;
  EXPECT_EQ(error(values), "value 18 of 512: expected 0 or 1, got 2");
  EXPECT_EQ(error(Values(256)), "expected 512 values, got 256");
  EXPECT_EQ(rejection_of([] { return table_from_removals(Values(512), kRasterOrder); }),
            "expected 256 values, got 512");
  for (const NeighbourOrder& order :
       {NeighbourOrder{0, 1, 2, 3, 4, 5, 6, 7}, NeighbourOrder{0, 1, 2, 3, 5, 6, 7, 7},
        NeighbourOrder{0, 1, 2, 3, 5, 6, 7, 200}}) {
    EXPECT_EQ(rejection_of([&] { return table_from_removals(Values(256), order); }),
              "an order of neighbours must name each of the pixels 0 to 3 and 5 to 8 once");
  }
}

}  // namespace
}  // namespace thinbench
