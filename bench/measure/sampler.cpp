// The sampler: verifies rows and plans their measurement, or carries out a plan. `./study` starts
// it; see docs/measuring.md.
#include <algorithm>
#include <iostream>
#include <iterator>
#include <sstream>

#include <nlohmann/json.hpp>

#include "cli/arguments.hpp"
#include "cli/parse_errors.hpp"
#include "cli/reported.hpp"
#include "cli/usage.hpp"
#include "measure/measuring.hpp"
#include "measure/plan_json.hpp"
#include "measure/row_options.hpp"
#include "peers/peers.hpp"
#include "support/progress.hpp"

namespace thinbench {
namespace {

struct SamplerOptions {
  InputChoice inputs;
  RowChoice rows;
  PlanLimits limits;
  std::uint64_t seed = 0;
};

/// Rows that take longer are listed as skipped. Meanwhile samples the clock.
std::vector<CalibratedRow> calibrate_all(Selection& selection, double max_seconds,
                                         std::vector<double>& cycles) {
  std::ostringstream reason;
  reason << "a call takes more than " << max_seconds << " s";
  std::vector<CalibratedRow> rows;
  Progress progress("calibrating", static_cast<double>(selection.rows.size()));
  for (const TimedRow& row : selection.rows) {
    rows.push_back(calibrate(row));
    if (rows.back().seconds > max_seconds) {
      rows.pop_back();
      selection.skipped.push_back({row.name, reason.str()});
    }
    for (int i = 0; i < 20; ++i) cycles.push_back(cycle_ns());
    progress.advance(1);
  }
  return rows;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Rows of one case and input follow each other.
std::vector<std::vector<CalibratedRow>> by_case_and_input(const std::vector<CalibratedRow>& rows) {
  std::vector<std::vector<CalibratedRow>> groups;
  for (const CalibratedRow& row : rows) {
    const bool same = !groups.empty() &&
                      groups.back().front().row->operation == row.row->operation &&
                      groups.back().front().row->input == row.row->input;
    if (!same) groups.emplace_back();
    groups.back().push_back(row);
  }
  return groups;
}

int plan(const SamplerOptions& options) {
  const std::vector<TimedInput> inputs = timed_inputs(options.inputs, &std::cerr);
  Selection selection = select_rows_or_explain(options.rows, operations_with_peers(), inputs);
  std::vector<double> cycles = {cycle_ns()};
  const std::vector<CalibratedRow> rows =
      calibrate_all(selection, options.limits.max_call_seconds, cycles);
  Plan plan{options.inputs, median(cycles), {}};
  for (const auto& group : by_case_and_input(rows)) {
    plan.groups.push_back(plan_group(group, options.limits));
  }
  std::cout << plan_json(plan, selection, inputs, rows)
                   .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)
            << '\n';
  return selection.mismatches.empty() ? kSuccess : kUsage;
}

/// A line for each group and one for the machine, before and after.
int measure_plan(const SamplerOptions& options) {
  const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  const Plan plan = plan_from_json(text);
  const std::vector<TimedInput> inputs = timed_inputs(plan.inputs);
  const auto print_state = [] {
    std::cout << nlohmann::json{{"chain_ns", shortest_cycle_ns()}}.dump() << std::endl;
  };
  print_state();
  measure(plan, options.seed, operations_with_peers(), inputs, [](const GroupTimes& times) {
    std::cout << group_times_json(times).dump() << std::endl;
  });
  print_state();
  return kSuccess;
}

void add_plan_options(CLI::App& app, SamplerOptions& options) {
  add_row_options(app, options.inputs, options.rows);
  app.add_option("--seconds-per-row", options.limits.seconds_per_row,
                 "in each process; every row is called in each layout, whatever it takes")
      ->capture_default_str()
      ->check(real_number(0, 100))
      ->type_name("S");
  app.add_option("--max-call", options.limits.max_call_seconds,
                 "rows whose call takes longer are verified, but not measured")
      ->capture_default_str()
      ->check(real_number(0, 1e6))
      ->type_name("S");
}

int run(const std::vector<std::string>& arguments) {
  SamplerOptions options;
  CLI::App app("Verify rows and plan their measurement, or measure a plan", "thinbench_sampler");
  app.require_subcommand(1);
  CLI::App* plan_app = app.add_subcommand(
      "plan", "Verify rows against their references; write the plan to standard output as JSON");
  add_plan_options(*plan_app, options);
  CLI::App* measure_app = app.add_subcommand(
      "measure", "Measure the plan on standard input; write a line of JSON for each group");
  measure_app->add_option("--seed", options.seed, "of the order of measurements")
      ->check(whole_number(0, 1'000'000))
      ->type_name("N");
  app.footer(
      "Exit status: 0 done, 1 failure, 2 wrong usage or a row that differs from its reference.\n"
      "Examples:\n"
      "  thinbench_sampler plan --filter '^thin_guo_hall/' > plan.json\n"
      "  thinbench_sampler measure --seed 1 < plan.json");
  if (!parse_or_help(app, arguments)) return kSuccess;
  return plan_app->parsed() ? plan(options) : measure_plan(options);
}

}  // namespace
}  // namespace thinbench

int main(int argc, char** argv) {
  return thinbench::run_and_report("thinbench_sampler", std::cout, std::cerr, [&] {
    return thinbench::run({argv + (argc > 0 ? 1 : 0), argv + argc});
  });
}
