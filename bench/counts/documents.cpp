#include "counts/documents.hpp"

#include <fmt/format.h>
#include <gnu/libc-version.h>

#include "measure/build_facts.hpp"
#include "measure/known_rows.hpp"

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

Json count_json(const RowCount& count) {
  const TimedRow& row = *count.row;
  Json json = {{"row", row.name}};
  json.update(row_json(row));
  json.update({{"instructions", count.instructions}, {"method", method_name(count.method)}});
  if (row.iterations) json["iterations"] = *row.iterations;
  return json;
}

/// What must be equal for counts to be comparable: compiler and flags, the C library and the
/// highest ISA of the processor, which its functions choose by.
Json build_json() {
  return {{"compiler", compiler_json()},
          {"libc", gnu_get_libc_version()},
          {"processor_level", processor_level()}};
}

}  // namespace

Json counts_json(const TimedInput& input, const RowCounts& counts, std::uint64_t max_steps) {
  Json document = {{"schema", 3},
                   {"kind", "instructions"},
                   {"build", build_json()},
                   {"valgrind", counts.callgrind.version},
                   {"input", input_json(input)},
                   {"rows", Json::array()},
                   {"skipped", Json::array()},
                   {"max_steps", max_steps}};
  for (const RowCount& count : counts.rows) document["rows"].push_back(count_json(count));
  for (const SkippedRow& row : counts.skipped) {
    document["skipped"].push_back({{"row", row.name}, {"reason", row.reason}});
  }
  return document;
}

std::string counts_table(const RowCounts& counts) {
  std::string text =
      fmt::format("{:<80} {:>12} {:>10}  {}\n", "row", "instructions", "iterations", "counted by");
  for (const RowCount& count : counts.rows) {
    const auto& iterations = count.row->iterations;
    text += fmt::format("{:<80} {:>12} {:>10}  {}\n", count.row->name, count.instructions,
                        iterations ? std::to_string(*iterations) : "", method_name(count.method));
  }
  return text;
}

}  // namespace thinbench
