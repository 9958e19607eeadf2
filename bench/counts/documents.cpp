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

Json limit_json(const RowLimit& limit, const Limits& limits) {
  const auto& [count, code] = limit.code;
  Json json = row_json(count);
  json["ns"] = rounded(limit.seconds * 1e9, 10);
  json["cycles"] = rounded(limits.cycles(limit), 1);
  json["instructions_per_cycle"] = rounded(limits.instructions_per_cycle(limit), 1000);
  if (const auto each = instructions_per_row_and_iteration(count)) {
    json["instructions_per_row_and_iteration"] = rounded(*each, 10);
  }
  json["code"] = {{"instructions", code.instructions}, {"order", code.order}};
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

Json limits_json(const TimedInput& input, const Limits& limits) {
  Json document = document_of("limits", kLimitsSchema, input, {}, limits.skipped);
  document["cycle_ns"] = rounded(limits.seconds_per_cycle * 1e9, 1e5);
  for (const RowLimit& limit : limits.rows) document["rows"].push_back(limit_json(limit, limits));
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

std::string limits_table(const Limits& limits) {
  std::string text = fmt::format("{:<80} {:>12} {:>10} {:>10} {:>9}\n", "row", "instructions", "us",
                                 "cycles", "per cycle");
  for (const RowLimit& limit : limits.rows) {
    const RowCount& count = limit.code.count;
    text += fmt::format("{:<80} {:>12} {:>10.2f} {:>10.0f} {:>9.2f}\n", count.row->name,
                        count.instructions, limit.seconds * 1e6, limits.cycles(limit),
                        limits.instructions_per_cycle(limit));
  }
  return text;
}

}  // namespace thinbench
