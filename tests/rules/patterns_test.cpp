// Pillow's patterns: its tables of its own lists, of none and of random ones, whitespace, errors.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "rules/recorded_tables.hpp"
#include "support/rejection.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench {
namespace {

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

}  // namespace
}  // namespace thinbench
