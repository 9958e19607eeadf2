#include "regress/compare.hpp"

#include <algorithm>
#include <set>

#include "paired/row_names.hpp"
#include "paired/statistics.hpp"
#include "support/text.hpp"

namespace thinbench {
namespace {

using Logs = std::vector<double>;

RegressionVerdict skipped(const std::string& name, const std::string& reason) {
  RegressionVerdict row;
  row.name = name;
  row.reason = reason;
  return row;
}

Change change_of(const Logs& logs, double divisor = 1) {
  const Estimate estimate = estimate_of(logs);
  return {estimate.ratio / divisor, estimate.low / divisor, estimate.high / divisor};
}

/// Process by process.
Logs difference(const Logs& now, const Logs& before) {
  Logs logs;
  for (std::size_t i = 0; i < now.size(); ++i) logs.push_back(now[i] - before.at(i));
  return logs;
}

/// Empty where nothing speaks against judging the row.
std::string why_not_judged(const MeasuredRow& row, std::size_t processes, const Rules& rules) {
  if (row.threaded && !rules.judge_threads) return "threads: reported, not judged";
  if (row.logs.size() != processes) return "not measured by every process";
  return {};
}

void give_verdict(RegressionVerdict& row) {
  if (row.reason.empty()) row.verdict = judge(row.change, row.tolerance);
}

RegressionVerdict row_against(const MeasuredRow& row, const BaselineRow& before,
                              std::size_t processes, const Rules& rules) {
  RegressionVerdict verdict = skipped(row.name, why_not_judged(row, processes, rules));
  if (row.input_hash != before.input_hash) verdict.reason = "another picture than in the baseline";
  verdict.tolerance = tolerance_of(kStoredTolerance, row.pixels, rules.cache_kib);
  verdict.change = change_of(row.logs, before.speedup.ratio);
  verdict.before = before.times;
  verdict.now = row.times;
  give_verdict(verdict);
  return verdict;
}

RegressionVerdict row_between(const MeasuredRow& before, const MeasuredRow& now,
                              std::size_t processes, const Rules& rules) {
  RegressionVerdict verdict = skipped(now.name, why_not_judged(now, processes, rules));
  if (before.logs.size() != now.logs.size()) {
    verdict.reason = "not measured by every process";
    return verdict;
  }
  verdict.tolerance = tolerance_of(kOneJobTolerance, now.pixels, rules.cache_kib);
  verdict.change = change_of(difference(now.logs, before.logs));
  verdict.before = before.times;
  verdict.now = now.times;
  give_verdict(verdict);
  return verdict;
}

template <class Rows>
std::map<std::string, std::set<std::string>> names_by_group(const Rows& rows) {
  std::map<std::string, std::set<std::string>> names;
  for (const auto& [name, row] : rows) names[group_of(name)].insert(name);
  return names;
}

template <class RowsBefore>
void doubt_new_neighbours(const RowsBefore& before, const MeasuredRun& run,
                          std::vector<RegressionVerdict>& rows) {
  const auto then = names_by_group(before);
  const auto now = names_by_group(run.rows);
  for (RegressionVerdict& row : rows) {
    if (row.verdict != Verdict::fail) continue;
    const std::string group = group_of(row.name);
    if (then.at(group) == now.at(group)) continue;
    row.verdict = Verdict::undecided;
    row.reason = "measured beside other rows than before";
  }
}

/// Rows of both, and what only one of them has.
template <class RowsBefore, class Judge>
std::vector<RegressionVerdict> compared(const RowsBefore& before, const MeasuredRun& run,
                                        const Judge& judge_row) {
  std::vector<RegressionVerdict> rows;
  for (const auto& [name, row] : run.rows) {
    const auto earlier = before.find(name);
    rows.push_back(earlier == before.end() ? skipped(name, "new: there is nothing to compare with")
                                           : judge_row(earlier->second, row));
  }
  for (const auto& [name, row] : before) {
    if (run.rows.count(name) == 0) rows.push_back(skipped(name, "not measured in this run"));
  }
  doubt_new_neighbours(before, run, rows);
  return rows;
}

/// The technique that does the same without SIMD; empty where it is the reference.
std::string scalar_technique(const std::string& technique) {
  if (technique.starts_with("simd_bitpacked")) return "bitpacked";
  return technique == "simd_runs" ? "bitpacked_runs" : "";
}

const MeasuredRow* scalar_row(const MeasuredRun& run, std::vector<std::string> fields) {
  fields[1] = scalar_technique(fields[1]);
  fields[2] = "baseline";
  const auto found = run.rows.find(joined(fields, "/"));
  return found == run.rows.end() ? nullptr : &found->second;
}

RegressionVerdict simd_against_scalar(const MeasuredRun& run, const MeasuredRow& row) {
  const MeasuredRow* scalar = scalar_row(run, fields_of(row.name));
  RegressionVerdict verdict = skipped(row.name, why_not_judged(row, run.processes, {}));
  if (scalar != nullptr && scalar->logs.size() != run.processes) {
    verdict.reason = "not measured by every process";
  }
  if (!verdict.reason.empty()) return verdict;
  verdict.tolerance = kOneJobTolerance;
  verdict.change = change_of(scalar == nullptr ? row.logs : difference(row.logs, scalar->logs));
  const double scalar_ns = scalar == nullptr ? row.times.reference_ns : scalar->times.row_ns;
  verdict.before = {row.times.reference_ns, scalar_ns};
  verdict.now = row.times;
  give_verdict(verdict);
  return verdict;
}

}  // namespace

std::vector<RegressionVerdict> against_baseline(const MeasuredRun& run, const Baseline& baseline,
                                                const Rules& rules) {
  return compared(baseline.rows, run, [&](const BaselineRow& before, const MeasuredRow& now) {
    return row_against(now, before, run.processes, rules);
  });
}

std::vector<RegressionVerdict> between(const MeasuredRun& before, const MeasuredRun& now,
                                       const Rules& rules) {
  return compared(before.rows, now, [&](const MeasuredRow& earlier, const MeasuredRow& row) {
    return row_between(earlier, row, now.processes, rules);
  });
}

std::vector<RegressionVerdict> against_scalar(const MeasuredRun& run) {
  std::vector<RegressionVerdict> rows;
  for (const auto& [name, row] : run.rows) {
    const bool is_simd = fields_of(name)[1].starts_with("simd");
    if (is_simd && !row.threaded) rows.push_back(simd_against_scalar(run, row));
  }
  return rows;
}

void doubt(const ControlVerdicts& controls, std::vector<RegressionVerdict>& rows) {
  for (RegressionVerdict& row : rows) {
    const bool failed = !controls.pass || controls.failed_groups.count(group_of(row.name)) > 0;
    if (!failed || row.verdict == Verdict::skipped) continue;
    row.verdict = Verdict::undecided;
    row.reason = "a control failed";
  }
}

void confirm(const std::vector<RegressionVerdict>& again, std::vector<RegressionVerdict>& rows) {
  for (RegressionVerdict& row : rows) {
    const auto found =
        std::find_if(again.begin(), again.end(), [&](const RegressionVerdict& other) {
          return other.name == row.name && other.verdict != Verdict::skipped;
        });
    if (found == again.end()) continue;
    const Verdict first = row.verdict;
    row = *found;
    row.verdict = confirmed(first, found->verdict);
    if (row.verdict != found->verdict && row.reason.empty()) {
      row.reason =
          "first " + std::string(name_of(first)) + ", then " + std::string(name_of(found->verdict));
    }
  }
}

}  // namespace thinbench
