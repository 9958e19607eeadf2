#include "paired/output.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "harness/case_json.hpp"
#include "paired/row_names.hpp"
#include "support/text.hpp"

namespace thinbench {
namespace {

using nlohmann::json;

/// Five digits, never an exponent for what is timed here.
std::string digits(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.5g", value);
  return std::abs(value) < 1e5 ? text.data() : fixed(value, 0);
}

/// Names of pictures may hold anything.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// Without case and input, which the row says: technique/isa/threads/scope.
std::string short_name(const Entry& entry) {
  const std::vector<std::string> fields = fields_of(entry.name);
  return joined({fields.begin() + 1, fields.end() - 1}, "/");
}

std::vector<std::string> csv_fields(const PairResult& result) {
  std::vector<std::string> fields = fields_of(result.row->name);
  const CaseLabels& labels = result.row->labels;
  if (!labels.operation.empty()) fields.front() = labels.operation;
  const std::vector<std::string> more = {
      result.against,
      digits(result.estimate.ratio),
      digits(result.estimate.low),
      digits(result.estimate.high),
      std::to_string(result.processes),
      std::to_string(result.rounds),
      digits(result.base_ns),
      digits(result.row_ns),
      result.clock(),
      std::to_string(result.layout.at(0)) + "+" + std::to_string(result.layout.at(1)),
      result.row->hash,
      joined(result.flags, ";"),
      "1",
      short_name(*result.base),
      labels.border,
      labels.max_iterations ? std::to_string(*labels.max_iterations) : ""};
  fields.insert(fields.end(), more.begin(), more.end());
  for (std::string& field : fields) field = csv_field(field);
  return fields;
}

const char* verdict_of(const Controls& controls) {
  return controls.pass() ? "PASS" : "INCONCLUSIVE";
}

json estimate_json(const Estimate& estimate) {
  return {{"ratio", estimate.ratio}, {"low", estimate.low}, {"high", estimate.high}};
}

json run_json(const std::vector<PairResult>& results) {
  const std::size_t processes = results.front().processes;
  const Ranks ranks = interval_ranks(processes);
  const Controls controls = controls_of(results);
  return {{"schema", 1},
          {"kind", "run"},
          {"processes", processes},
          {"interval_ranks", {ranks.low, ranks.high}},
          {"coverage", ranks.coverage},
          {"epoch_seconds", kEpoch},
          {"control_same", estimate_json(controls.same)},
          {"control_slowed", estimate_json(controls.slowed)},
          {"groups", controls.groups},
          {"groups_with_failed_control", controls.failed_groups},
          {"verdict", verdict_of(controls)}};
}

json clock_json(const ClockTimes& times) {
  return {{"ns", std::round(times.ns * 10) / 10}, {"logs", times.logs}};
}

bool is_base_of_threads(const Group& group, std::size_t entry) {
  return std::any_of(group.pairs.begin(), group.pairs.end(), [&](const Pair& pair) {
    return pair.base == entry && group.entries[pair.row].threaded;
  });
}

const char* role_name(Role role) {
  return role == Role::row ? "row" : role == Role::same ? "same" : "slowed";
}

json sample_json(const Group& group, std::size_t index, const GroupTimes& times,
                 std::size_t process) {
  const Entry& entry = group.entries[index];
  json sample = {{"kind", role_name(entry.role)},
                 {"row", entry.name},
                 {"process", process},
                 {"calls", entry.calls},
                 {"anchor", group.entries[group.anchor].name},
                 {"output_hash", entry.hash},
                 {"input_hash", entry.input.hash},
                 {"pixels", entry.input.pixels},
                 {"layout", times.layout}};
  sample.update(labels_json<json>(entry.labels));
  if (entry.calls != entry.counted) sample["counted"] = entry.counted;
  if (!entry.threaded) sample["thread_cpu"] = clock_json(times.entries[index].thread_cpu);
  if (entry.threaded || is_base_of_threads(group, index)) {
    sample["wall"] = clock_json(times.entries[index].wall);
  }
  return sample;
}

std::string table_line(const PairResult& result) {
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), "%-74s %9.2f us %9s x  (%s to %s)  %s\n",
                result.row->name.c_str(), result.row_ns / 1000,
                digits(result.estimate.ratio).c_str(), digits(result.estimate.low).c_str(),
                digits(result.estimate.high).c_str(), joined(result.flags, " ").c_str());
  return text.data();
}

}  // namespace

std::string to_csv(const std::vector<PairResult>& results) {
  std::string text =
      "operation,technique,isa,threads,scope,input,against,ratio,low,high,processes,rounds,"
      "reference_ns,variant_ns,clock,layout,output_hash,flags,verified,against_row,border,"
      "max_iterations\n";
  for (const PairResult& result : results) text += joined(csv_fields(result), ",") + "\n";
  return text;
}

std::string to_json_lines(const std::vector<Group>& groups,
                          const std::vector<std::vector<GroupTimes>>& processes,
                          const std::vector<PairResult>& results) {
  std::string text = run_json(results).dump() + "\n";
  for (std::size_t process = 0; process < processes.size(); ++process) {
    for (std::size_t group = 0; group < groups.size(); ++group) {
      for (std::size_t entry = 0; entry < groups[group].entries.size(); ++entry) {
        text += sample_json(groups[group], entry, processes[process].at(group), process).dump();
        text += "\n";
      }
    }
  }
  return text;
}

std::string to_table(const std::vector<PairResult>& results) {
  std::string text;
  for (const PairResult& result : results) {
    if (result.against == "reference" || result.is_control()) text += table_line(result);
  }
  return text;
}

std::string verdict_line(const std::vector<PairResult>& results) {
  const std::size_t processes = results.front().processes;
  const Ranks ranks = interval_ranks(processes);
  const Controls controls = controls_of(results);
  return std::string(verdict_of(controls)) + ": a row against itself " +
         digits(controls.same.ratio) + ", slowed by 10 % " + digits(controls.slowed.ratio) + "; " +
         std::to_string(controls.failed_groups) + " of " + std::to_string(controls.groups) +
         " cases flagged by their own controls; intervals from " + std::to_string(ranks.low) +
         " to " + std::to_string(ranks.high) + " of " + std::to_string(processes) +
         " ordered process values, coverage " + fixed(100 * ranks.coverage, 1) + " %";
}

}  // namespace thinbench
