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
Limits known_limits() {
  static const Selection selection = select_rows(
      {.filter = "^thin_guo_hall/lut/baseline/1/end_to_end"}, all_operations(), scene());
  Limits limits;
  limits.seconds_per_cycle = 1e-9 / 3;
  limits.rows.push_back({{{&selection.rows.back(), 9000}, {"90 c3", "0-1*1"}}, 1e-6});
  return limits;
}

TEST(Limits, time_and_length_of_a_cycle_make_cycles) {
  const Limits limits = known_limits();
  EXPECT_NEAR(limits.cycles(limits.rows[0]), 3000, 1e-6);
  EXPECT_NEAR(limits.instructions_per_cycle(limits.rows[0]), 3, 1e-9);
}

TEST(Limits, the_file_has_one_cycle_and_for_each_row_its_cycles_and_its_code) {
  const auto json = limits_json(scene().front(), known_limits());
  EXPECT_EQ(json.at("schema"), 2);
  EXPECT_EQ(json.at("cycle_ns"), 0.33333);
  const auto& row = json.at("rows").at(0);
  EXPECT_EQ(row.at("cycles"), 3000);
  EXPECT_EQ(row.at("code"),
            (nlohmann::ordered_json{{"instructions", "90 c3"}, {"order", "0-1*1"}}));
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
