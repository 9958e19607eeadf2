// thinbench-study instructions: what rows execute, counted exactly.
#include <memory>
#include <string>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "counts/documents.hpp"
#include "measure/timed_row.hpp"
#include "study/study.hpp"
#include "support/text.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

struct InstructionsOptions {
  std::string filter;
  std::string image;
  std::string out;
  BinariseOptions binarise;
  std::uint64_t max_steps = 0;  // 0 for what takes a minute or two
  bool json = false;

  [[nodiscard]] std::uint64_t steps() const {
    if (max_steps > 0) return max_steps;
    return why_no_callgrind().empty() ? 400000 : 30000;
  }
};

/// One, in the form that rows are selected by.
std::vector<TimedInput> inputs_for(const InstructionsOptions& options, std::ostream& log) {
  std::vector<std::string> pictures;
  if (!options.image.empty()) pictures.push_back(options.image);
  std::vector<TimedInput> inputs = timed_inputs({pictures, options.binarise, {}}, &log);
  inputs.front() = small_copy(inputs.front());
  return inputs;
}

/// The rows on one thread, verified.
Selection selected(const InstructionsOptions& options, const std::vector<TimedInput>& inputs) {
  Selection selection =
      select_rows_or_explain({.filter = options.filter, .peers = false}, all_operations(), inputs);
  if (!selection.mismatches.empty()) {
    throw std::runtime_error("rows that are not equal to their references are not counted");
  }
  report_skipped(selection);
  std::erase_if(selection.rows, [](const TimedRow& row) {
    return row.variant == nullptr || row.variant->threaded;
  });
  if (selection.rows.empty()) {
    throw UsageError("no row to count; the filter '" + options.filter +
                     "' matches only references or rows with threads");
  }
  return selection;
}

void report_skipped(const RowCounts& counts, std::uint64_t max_steps, std::ostream& log) {
  if (!counts.callgrind.why_not.empty()) {
    log << counts.callgrind.why_not << ": rows are counted by single steps instead\n";
  }
  if (counts.skipped.empty()) return;
  log << counted(counts.skipped.size(), "row was", "rows were") << " not counted: more than "
      << max_steps << " single steps\n";
}

int run(const InstructionsOptions& options, const Console& console) {
  if (!options.out.empty()) check_target(options.out);
  const std::uint64_t max_steps = options.steps();
  const std::vector<TimedInput> inputs = inputs_for(options, console.err);
  const Selection selection = selected(options, inputs);
  const RowCounts counts = counts_of(selection.rows, max_steps);
  const std::string json = counts_json(inputs.front(), counts, max_steps).dump(1) + "\n";
  if (!options.out.empty()) write_whole_file(options.out, json);
  report_skipped(counts, max_steps, console.err);
  console.out << (options.json ? json : counts_table(counts));
  return kSuccess;
}

void add_options(CLI::App& app, InstructionsOptions& options) {
  app.add_option("--filter", options.filter, "Only rows whose name contains a match")
      ->type_name("REGEX");
  CLI::Option* image =
      add_file_option(app, "--image", options.image, "Image to take instead of the scene");
  add_binarise_options(app, options.binarise, image);
  add_value(app, "--max-steps", options.max_steps,
            "Skip rows that take more single steps (default: 400000, without valgrind 30000)",
            whole_number(1, 100000000), "N");
  app.add_flag("--json", options.json, "Print JSON instead of a table");
  add_file_option(app, "--out", options.out, "Write the data here, as JSON");
}

}  // namespace

Command add_instructions_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("instructions", "Count the instructions of rows");
  const auto options = std::make_shared<InstructionsOptions>();
  add_options(*app, *options);
  app->footer(R"(Examples:
  thinbench-study instructions --filter 'simd_.*/avx2' --out counts.json

Rows are named operation/technique/isa/threads/scope/input; those on one thread are counted. Where
valgrind is installed, its callgrind counts all but AVX-512; the rest is counted by a trap of the
processor after each instruction, which takes microseconds, and rows that take more than --max-steps
are skipped. So the input is small: every 5th pixel of every 16th row of the image.

./study regress compares the counts of two builds.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
