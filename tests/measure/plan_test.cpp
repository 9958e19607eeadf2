#include "measure/plan.hpp"

#include <algorithm>
#include <deque>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "measure/copy_operation.hpp"
#include "measure/measuring.hpp"
#include "measure/plan_json.hpp"
#include "support/rejection.hpp"

namespace thinbench {
namespace {

/// Rows of one operation, reference first, with made-up seconds per call.
class RowsForTests {
 public:
  explicit RowsForTests(double reference_seconds) { add(nullptr, "reference", reference_seconds); }

  void with(std::string_view technique, double seconds, Isa isa = Isa::baseline, int threads = 1) {
    variants_.push_back(copy_variant(technique, false));
    variants_.back().isa = isa;
    variants_.back().threaded = threads > 1;
    add(&variants_.back(), technique, seconds, threads);
  }

  [[nodiscard]] const std::vector<CalibratedRow>& rows() const { return calibrated_; }

 private:
  void add(const Variant* variant, std::string_view technique, double seconds, int threads = 1) {
    const std::string isa(variant == nullptr ? "baseline" : variant->isa_label());
    timed_.push_back({row_name("copy", technique, isa, threads) + "/end_to_end/scene", nullptr,
                      variant, threads, Scope::end_to_end, nullptr});
    calibrated_.push_back({&timed_.back(), seconds, "0123456789abcdef"});
  }

  std::deque<Variant> variants_;
  std::deque<TimedRow> timed_;
  std::vector<CalibratedRow> calibrated_;
};

TEST(Plan, epochs_of_all_short_rows_last_equally_long_and_long_calls_are_made_once) {
  RowsForTests rows(1e-2);
  rows.with("lut", 1e-4);
  rows.with("simd_bytes", 1e-5, Isa::avx2);
  const Group group = plan_group(rows.rows(), {});
  EXPECT_EQ(group.entries[0].calls, 1);
  EXPECT_EQ(group.entries[0].visits, 1);
  EXPECT_EQ(group.entries[1].calls, 3);
  EXPECT_EQ(group.entries[2].calls, 30);
}

TEST(Plan, controls_repeat_the_fastest_row_on_one_thread) {
  RowsForTests rows(1e-2);
  rows.with("lut", 1e-4);
  rows.with("simd_bytes", 2e-5, Isa::avx2);
  rows.with("simd_runs", 1e-5, Isa::avx2, 2);
  const Group group = plan_group(rows.rows(), {});
  const auto control = std::find_if(group.entries.begin(), group.entries.end(),
                                    [](const Entry& entry) { return entry.role == Role::same; });
  ASSERT_NE(control, group.entries.end());
  EXPECT_EQ(control->name, group.entries[2].name);
}

TEST(Plan, slowed_control_makes_the_same_calls_with_a_delay_of_a_tenth) {
  for (const double seconds : {1e-6, 3e-5, 9e-4, 5e-3}) {
    RowsForTests rows(1e-2);
    rows.with("lut", seconds);
    const Group group = plan_group(rows.rows(), {});
    const Entry& row = group.entries[1];
    const Entry& slowed = group.entries.back();
    EXPECT_EQ(slowed.role, Role::slowed);
    EXPECT_EQ(slowed.calls, row.calls) << seconds;
    EXPECT_DOUBLE_EQ(slowed.delay_ns, 1e8 * seconds);
    EXPECT_EQ(row.delay_ns, 0);
  }
}

TEST(Plan, visits_keep_to_the_time_of_a_row_but_there_is_one_in_each_layout) {
  RowsForTests rows(1e-2);
  rows.with("lut", 1e-4);
  const Group group = plan_group(rows.rows(), {.seconds_per_row = 0.006});
  EXPECT_DOUBLE_EQ(group.entries[0].seconds, group.layouts * 1e-2);
  EXPECT_GT(group.entries[1].visits, 1);
  EXPECT_LE(group.entries[1].seconds, 0.006);
  EXPECT_GT(group.entries[1].seconds, 0.003);
  EXPECT_EQ(plan_group(rows.rows(), {.seconds_per_row = 0}).entries[1].visits, 1);
}

/// Everything that a process needs is in the text: writing the plan again gives the same.
TEST(PlanJson, is_read_back_as_it_was_written) {
  const std::vector<TimedInput> inputs = timed_inputs({{}, {Foreground::dark, 80}, {"square_64"}});
  const std::vector<Operation> operations = copy_operations();
  const Selection selection = select_rows({.filter = "copy/good/"}, operations, inputs);
  std::vector<CalibratedRow> rows;
  for (const TimedRow& row : selection.rows) rows.push_back(calibrate(row));
  const Plan plan = {
      {{"a.png"}, {Foreground::dark, 80}, {"square_64"}}, 0.25, {plan_group(rows, {})}};
  const nlohmann::json written = plan_json(plan, selection, inputs, rows);
  EXPECT_EQ(plan_json(plan_from_json(written.dump()), selection, inputs, rows), written);
  EXPECT_EQ(written.at("/inputs/0/width"_json_pointer), 64);
  EXPECT_EQ(written.at("rows").at("copy/good/baseline/1/end_to_end/square_64").at("technique"),
            "good");
}

TEST(PlanJson, rejects_other_texts) {
  EXPECT_EQ(rejection_of<std::runtime_error>([] { static_cast<void>(plan_from_json("{}")); }),
            "standard input: groups is missing");
}

TEST(PlanJson, rejects_numbers_that_cannot_be_measured_by) {
  const auto rejection_with = [](const char* key, const nlohmann::json& value) {
    nlohmann::json entry = {{"name", "a"},       {"role", "row"},  {"calls", 1},
                            {"delay_ns", 0},     {"warm_up", 0},   {"visits", 1},
                            {"threaded", false}, {"seconds", 1.0}, {"hash", ""}};
    entry[key] = value;
    const nlohmann::json plan = {{"sources",
                                  {{"pictures", nlohmann::json::array()},
                                   {"drawn", nlohmann::json::array()},
                                   {"foreground", "auto"},
                                   {"threshold", nullptr}}},
                                 {"cycle_ns", 0.25},
                                 {"groups", {{{"layouts", 3}, {"entries", {entry}}}}}};
    return rejection_of<std::runtime_error>(
        [&] { static_cast<void>(plan_from_json(plan.dump())); });
  };
  EXPECT_EQ(rejection_with("calls", 2), "");
  EXPECT_EQ(rejection_with("delay_ns", -0.5),
            "standard input: groups[0].entries[0].delay_ns must be a number of at least 0");
  EXPECT_EQ(rejection_with("visits", -1),
            "standard input: groups[0].entries[0].visits is -1, not from 1 to 2147483647");
  EXPECT_EQ(rejection_with("calls", 1e300),
            "standard input: groups[0].entries[0].calls must be an integer");
}

TEST(Measure, adds_the_delay_to_every_call) {
  const std::vector<TimedInput> inputs = timed_inputs({{}, {}, {"square_64"}});
  const std::vector<Operation> operations = copy_operations();
  const Selection selection = select_rows({.filter = "copy/good/"}, operations, inputs);
  Plan plan = {{}, 0.25, {plan_group({calibrate(selection.rows.at(0))}, {})}};
  for (Entry& entry : plan.groups[0].entries) {
    entry.calls = entry.role == Role::slowed ? 5 : 1;
    entry.delay_ns = 1e5;
  }
  measure(plan, 1, operations, inputs, [](const GroupTimes& times) {
    for (const EntryTimes& entry : times.entries) {
      EXPECT_GE(*std::min_element(entry.begin(), entry.end()), 0.9e5);
    }
  });
}

TEST(Measure, gives_times_and_stops_where_a_result_is_not_the_verified_one) {
  const std::vector<TimedInput> inputs = timed_inputs({{}, {}, {"square_64"}});
  const std::vector<Operation> operations = copy_operations();
  const Selection selection = select_rows({.filter = "copy/good/"}, operations, inputs);
  std::vector<CalibratedRow> rows;
  for (const TimedRow& row : selection.rows) rows.push_back(calibrate(row));
  Plan plan = {{}, 0.25, {plan_group(rows, {})}};
  Group& group = plan.groups[0];
  std::vector<GroupTimes> found;
  const auto sink = [&](const GroupTimes& times) { found.push_back(times); };
  measure(plan, 1, operations, inputs, sink);
  ASSERT_EQ(found.size(), static_cast<std::size_t>(group.layouts));
  for (const GroupTimes& times : found) {
    ASSERT_EQ(times.entries.size(), group.entries.size());
    for (std::size_t i = 0; i < group.entries.size(); ++i) {
      EXPECT_EQ(times.entries[i].size(), static_cast<std::size_t>(group.entries[i].visits));
    }
  }
  group.entries.back().hash = "another";
  EXPECT_NE(rejection_of<std::runtime_error>([&] {
              measure(plan, 1, operations, inputs, sink);
            }).find("gave another result"),
            std::string::npos);
}

}  // namespace
}  // namespace thinbench
