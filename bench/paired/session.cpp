#include "paired/session.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <stdexcept>

#include "cli/command.hpp"
#include "paired/options.hpp"
#include "paired/output.hpp"
#include "support/whole_file.hpp"
#include "timing/progress.hpp"
#include "timing/row_selection.hpp"
#include "timing/timed_call.hpp"

namespace thinbench {
namespace {

/// How often a call is made again that took so long. What takes longer than any interruption is
/// slow.
int more_calls(double seconds) {
  constexpr double kLongerThanInterruptions = 0.1;
  if (seconds > kLongerThanInterruptions) return 0;
  return seconds > kSlowCall ? 1 : 5;
}

/// The least disturbed call counts: one that was interrupted would make epochs of too few calls, in
/// which a row seems slower by half and more. The first call also touches every page.
CalibratedRow calibrated(const TimedRow& row) {
  TimedCall call(row);
  const auto timed = [&] {
    const auto start = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  double seconds = timed();
  for (int i = more_calls(seconds); i > 0; --i) seconds = std::min(seconds, timed());
  std::string hash = hash_of(call.outcome());
  const ConstImageView input = row.input->view(row.operation->takes);
  return {&row,
          seconds,
          std::move(hash),
          {pixel_hash(input), input.width * input.height},
          row.operation->labels()};
}

/// Rows by case and input, in the order of the selection; reference first.
std::vector<std::vector<CalibratedRow>> calibrated_rows(const std::vector<TimedRow>& rows) {
  std::vector<std::vector<CalibratedRow>> groups;
  Progress progress("calibrating", static_cast<double>(rows.size()));
  for (const TimedRow& row : rows) {
    if (row.variant == nullptr) groups.emplace_back();
    groups.back().push_back(calibrated(row));
    progress.advance(1);
  }
  return groups;
}

/// Takes away what is too slow for the limit; returns how many rows that is.
std::size_t leave_out_slow(double slowest_ms, std::vector<CalibratedRow>& rows) {
  const std::size_t before = rows.size();
  const bool slow_reference = rows.front().seconds > kSlowReference * slowest_ms / 1000;
  std::erase_if(rows, [&](const CalibratedRow& row) {
    const bool slow = row.seconds > slowest_ms / 1000;
    return row.row->variant != nullptr && (slow || slow_reference);
  });
  return before - rows.size();
}

std::vector<Group> planned(const Selection& selection, const PairedOptions& options) {
  std::vector<Group> groups;
  std::size_t left_out = 0;
  for (std::vector<CalibratedRow>& rows : calibrated_rows(selection.rows)) {
    left_out += leave_out_slow(options.slowest_ms, rows);
    if (rows.size() > 1) groups.push_back(plan_group(rows, options.limits));
  }
  if (left_out > 0) std::cerr << "rows left out: " << left_out << " (too slow for --slowest)\n";
  if (groups.empty()) {
    throw UsageError("no pair to measure; the filter is '" + options.filter + "'");
  }
  return groups;
}

std::vector<GroupTimes> measured_by_one(const Order& order, std::uint64_t seed,
                                        const Measurer& measurer, Progress& progress) {
  std::vector<GroupTimes> result(order.groups.size());
  std::size_t answers = 0;
  measurer(to_line(order), seed, [&](const std::string& line) {
    GroupTimes times = group_times_from(line);
    progress.advance(order.groups.at(times.group).seconds);
    result.at(times.group) = std::move(times);
    ++answers;
  });
  if (answers != result.size()) throw std::runtime_error("a process left out measurements");
  return result;
}

std::vector<std::vector<GroupTimes>> measured(const Order& order, const PairedOptions& options,
                                              const Measurer& measurer) {
  const int processes = options.processes;
  double seconds = 0;
  for (const Group& group : order.groups) seconds += group.seconds * processes;
  std::cerr << "measuring " << order.groups.size() << " cases in " << processes
            << " processes, about " << std::lround(seconds) << " s\n";
  Progress progress("measuring", seconds);
  std::vector<std::vector<GroupTimes>> result;
  result.reserve(static_cast<std::size_t>(processes));
  for (int process = 0; process < processes; ++process) {
    const auto seed = options.first_seed + static_cast<std::uint64_t>(process);
    result.push_back(measured_by_one(order, seed, measurer, progress));
  }
  return result;
}

int run(const PairedOptions& options, const std::vector<Operation>& operations,
        const Measurer& measurer) {
  for (const std::string& path : {options.csv_out, options.samples_out}) {
    if (!path.empty()) check_target(path);
  }
  const std::vector<TimedInput> inputs =
      timed_inputs({options.pictures, 0, options.binarise, &std::cerr});
  const Selection selection = rows_asked_for(
      options.filter, operations, inputs, options.highest_level ? Levels::highest : Levels::all);
  const Order order{options.pictures, options.binarise, planned(selection, options)};
  const auto processes = measured(order, options, measurer);
  const std::vector<PairResult> results = results_of(order.groups, processes);
  if (!options.csv_out.empty()) write_whole_file(options.csv_out, to_csv(results));
  if (!options.samples_out.empty()) {
    write_whole_file(options.samples_out, to_json_lines(order.groups, processes, results));
  }
  if (!options.quiet) std::cout << to_table(results);
  std::cerr << verdict_line(results) << '\n';
  if (!selection.mismatches.empty()) return kUsage;
  return controls_of(results).pass() ? kSuccess : kInconclusive;
}

int measure_and_answer(std::uint64_t seed, const std::vector<Operation>& operations) {
  std::string line;
  std::getline(std::cin, line);
  measure(order_from(line), seed, operations,
          [](const std::string& answer) { std::cout << answer << std::flush; });
  return kSuccess;
}

}  // namespace

int run_paired(const std::vector<std::string>& arguments, const std::vector<Operation>& operations,
               const Measurer& measurer) {
  try {
    PairedOptions options;
    if (!parse_options(arguments, options)) return kSuccess;
    if (options.measure_with_seed)
      return measure_and_answer(*options.measure_with_seed, operations);
    return options.no_peers ? run(options, without_peers(operations), measurer)
                            : run(options, operations, measurer);
  } catch (const UsageError& error) {
    std::cerr << "thinbench_paired: " << error.what() << '\n';
    return kUsage;
  } catch (const std::exception& error) {
    std::cerr << "thinbench_paired: " << error.what() << '\n';
    return kFailure;
  }
}

}  // namespace thinbench
