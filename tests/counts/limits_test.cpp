#include "counts/limits.hpp"

#include <gtest/gtest.h>

#include "counts/documents.hpp"

namespace thinbench {
namespace {

const std::vector<TimedInput>& scene() {
  static const std::vector<TimedInput> inputs = timed_inputs({});
  return inputs;
}

/// A call of 1 us with 9000 instructions at 3 GHz.
RowLimit known_limit() {
  static const Selection selection = select_rows(
      {.filter = "^thin_guo_hall/lut/baseline/1/end_to_end"}, all_operations(), scene());
  return {{&selection.rows.back(), 9000}, {1e-6, 1e-9 / 3}};
}

TEST(Limits, instructions_time_and_frequency_make_the_limit) {
  EXPECT_NEAR(known_limit().instructions_per_cycle(), 3, 1e-9);
  EXPECT_NEAR(known_limit().limit_seconds(4) * 1e9, 750, 1e-6);
}

TEST(Limits, the_file_says_what_was_assumed_and_what_a_row_takes_in_an_iteration) {
  const auto json = limits_json(scene().front(), {{known_limit()}, {}}, 4);
  EXPECT_EQ(json.at("schema"), 1);
  EXPECT_EQ(json.at("issue_width"), 4);
  const auto& row = json.at("rows").at(0);
  EXPECT_EQ(row.at("percent_of_limit"), 75);
  EXPECT_EQ(row.at("limit_ns"), 750);
  const double iterations = row.at("iterations");
  EXPECT_NEAR(row.at("instructions_per_row_and_iteration"), 9000 / (412 * iterations), 0.05);
}

TEST(Limits, rows_that_take_long_are_left_out_untried) {
  const Selection selection = select_rows({.filter = "^thin_guo_hall/lut/baseline/1/end_to_end"},
                                          all_operations(), scene());
  const Limits limits = limits_of({selection.rows.back()}, 1000);
  EXPECT_TRUE(limits.rows.empty());
  EXPECT_EQ(limits.skipped.size(), 1U);
}

TEST(Limits, one_row_of_each_operation_is_fastest_and_end_to_end) {
  const Selection selection =
      select_rows({.filter = "^(thin_guo_hall|euler_number)/.*bitpacked/baseline/1"},
                  all_operations(), scene());
  std::vector<TimedRow> rows = selection.rows;
  std::erase_if(rows, [](const TimedRow& row) { return row.variant == nullptr; });
  const std::vector<TimedRow> fastest = fastest_rows(rows);
  ASSERT_EQ(fastest.size(), 2U);
  for (const TimedRow& row : fastest) EXPECT_EQ(row.scope, Scope::end_to_end);
  EXPECT_NE(fastest[0].operation, fastest[1].operation);
}

}  // namespace
}  // namespace thinbench
