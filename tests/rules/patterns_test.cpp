// Pillow's patterns: its own tables, hand-worked ones, errors.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "rules/recorded_tables.hpp"
#include "support/rejection.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench {
namespace {

using Patterns = std::vector<std::string>;

bool pixel(std::size_t window, int k) {
  return (window >> k & 1) != 0;
}

TEST(Patterns, equal_the_tables_of_pillow) {
  const nlohmann::json tables = recorded().at("pillow").at("tables");
  ASSERT_EQ(tables.size(), 26U);
  for (const nlohmann::json& one : tables) {
    const auto patterns = one.at("patterns").get<Patterns>();
    EXPECT_EQ(table_from_patterns(patterns), recorded_table(one.at("table")))
        << one.at("patterns").dump();
  }
}

TEST(Patterns, none_keep_every_pixel) {
  EXPECT_EQ(table_from_patterns({}),
            make_window_table([](std::size_t window) { return pixel(window, 4); }));
}

TEST(Patterns, pixels_are_in_raster_order) {
  const Patterns patterns = {"1:(... ... ...)->0", "1:(..1 ... 0..)->1"};
  EXPECT_EQ(table_from_patterns(patterns), make_window_table([](std::size_t window) {
              return pixel(window, 2) && !pixel(window, 6);
            }));
}

TEST(Patterns, rotations_give_the_four_neighbours) {
  const Patterns dilation = {"4:(.1. ... ...)->1"};
  EXPECT_EQ(table_from_patterns(dilation), make_window_table([](std::size_t window) {
              return pixel(window, 1) || pixel(window, 3) || pixel(window, 4) || pixel(window, 5) ||
                     pixel(window, 7);
            }));
}

TEST(Patterns, mirror_exchanges_west_and_east) {
  EXPECT_EQ(table_from_patterns(Patterns{"M:(... 10. ...)->1"}),
            table_from_patterns(Patterns{"1:(... 10. ...)->1", "1:(... .01 ...)->1"}));
}

TEST(Patterns, negation_also_exchanges_the_result) {
  EXPECT_EQ(table_from_patterns(Patterns{"N:(.0. .1. .X.)->0"}),
            table_from_patterns(Patterns{"1:(.0. .1. ...)->0", "1:(.1. .0. ...)->1"}));
}

TEST(Patterns, later_ones_override_earlier_ones) {
  EXPECT_EQ(table_from_patterns(Patterns{"1:(1.. ... ...)->1", "1:(... ... ...)->0"}),
            WindowTable());
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

}  // namespace
}  // namespace thinbench
