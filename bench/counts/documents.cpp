#include "counts/documents.hpp"

#include <cmath>

#include <fmt/format.h>
#include <gnu/libc-version.h>

#include "harness/case_json.hpp"
#include "machine/machine.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::ordered_json;

std::string processor_level() {
  Isa highest = Isa::baseline;
  for (const Isa isa : all_isas()) {
    if (cpu_supports(isa)) highest = isa;
  }
  return std::string(isa_name(highest));
}

Json document_of(const char* kind, int schema, const TimedInput& input,
                 const CallgrindUse& callgrind, const std::vector<SkippedRow>& skipped) {
  Json document = {{"schema", schema},
                   {"kind", kind},
                   {"build", build_json()},
                   {"valgrind", callgrind.version},
                   {"input",
                    {{"name", input.name},
                     {"width", input.width()},
                     {"height", input.height()},
                     {"hash", pixel_hash(input.binary.view())},
                     {"grey_hash", pixel_hash(input.grey.view())}}},
                   {"rows", Json::array()},
                   {"skipped", Json::array()}};
  for (const SkippedRow& row : skipped) {
    document["skipped"].push_back({{"row", row.name}, {"reason", row.reason}});
  }
  return document;
}

Json row_json(const RowCount& count) {
  const TimedRow& row = *count.row;
  Json json = {{"row", row.name}};
  json.update(case_json<Json>(*row.operation));
  json.update({{"technique", row.variant->technique},
               {"isa", row.variant->isa_label()},
               {"threads", row.threads},
               {"scope", scope_name(row.scope)},
               {"input", row.input->name},
               {"instructions", count.instructions},
               {"method", method_name(count.method)}});
  if (row.counter) json[std::string(row.operation->counter)] = *row.counter;
  return json;
}

/// What one row of pixels takes in one iteration; nothing where iterations are not counted.
std::optional<double> instructions_per_row_and_iteration(const RowCount& count) {
  const TimedRow& row = *count.row;
  if (row.operation->counter != "iterations" || row.counter.value_or(0) <= 0) return std::nullopt;
  return static_cast<double>(count.instructions) /
         static_cast<double>(*row.counter * row.input->height());
}

double rounded(double value, double scale) {
  return std::round(value * scale) / scale;
}

Json limit_json(const RowLimit& limit, double issue_width) {
  Json json = row_json(limit.count);
  json["ns"] = rounded(limit.time.seconds * 1e9, 10);
  json["cycle_ns"] = rounded(limit.time.seconds_per_cycle * 1e9, 1e5);
  json["instructions_per_cycle"] = rounded(limit.instructions_per_cycle(), 1000);
  json["limit_ns"] = rounded(limit.limit_seconds(issue_width) * 1e9, 10);
  json["percent_of_limit"] = rounded(100 * limit.instructions_per_cycle() / issue_width, 10);
  if (const auto each = instructions_per_row_and_iteration(limit.count)) {
    json["instructions_per_row_and_iteration"] = rounded(*each, 10);
  }
  return json;
}

std::string counter_of(const TimedRow& row) {
  return row.counter ? std::to_string(*row.counter) : "";
}

}  // namespace

Json build_json() {
  return {{"compiler", compiler_json()},
          {"libc", gnu_get_libc_version()},
          {"processor_level", processor_level()}};
}

Json counts_json(const TimedInput& input, const RowCounts& counts, std::uint64_t max_steps) {
  Json document =
      document_of(kInstructionsKind, kCountsSchema, input, counts.callgrind, counts.skipped);
  document["max_steps"] = max_steps;
  for (const RowCount& count : counts.rows) document["rows"].push_back(row_json(count));
  return document;
}

Json limits_json(const TimedInput& input, const Limits& limits, double issue_width) {
  Json document = document_of("limits", kLimitsSchema, input, limits.callgrind, limits.skipped);
  document["issue_width"] = issue_width;
  for (const RowLimit& limit : limits.rows) {
    document["rows"].push_back(limit_json(limit, issue_width));
  }
  return document;
}

std::string counts_table(const RowCounts& counts) {
  std::string text =
      fmt::format("{:<80} {:>12} {:>8}  {}\n", "row", "instructions", "counter", "counted by");
  for (const RowCount& count : counts.rows) {
    text += fmt::format("{:<80} {:>12} {:>8}  {}\n", count.row->name, count.instructions,
                        counter_of(*count.row), method_name(count.method));
  }
  return text;
}

std::string limits_table(const Limits& limits, double issue_width) {
  std::string text = fmt::format("{:<80} {:>12} {:>10} {:>9} {:>10} {:>9}\n", "row", "instructions",
                                 "us", "per cycle", "limit us", "of limit");
  for (const RowLimit& limit : limits.rows) {
    text += fmt::format("{:<80} {:>12} {:>10.2f} {:>9.2f} {:>10.2f} {:>7.0f} %\n",
                        limit.count.row->name, limit.count.instructions, limit.time.seconds * 1e6,
                        limit.instructions_per_cycle(), limit.limit_seconds(issue_width) * 1e6,
                        100 * limit.instructions_per_cycle() / issue_width);
  }
  return text;
}

}  // namespace thinbench
