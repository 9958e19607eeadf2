// thinbench-study instructions: what rows execute, counted exactly.
#include <memory>
#include <string>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "counts/documents.hpp"
#include "counts/row_counts.hpp"
#include "measure/timed_row.hpp"
#include "study/study.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

struct InstructionsOptions {
  std::string filter;
  std::string image;
  std::string out;
  BinariseOptions binarise;
  std::uint64_t max_steps = 0;  // 0 for what suits the input
  bool json = false;

  [[nodiscard]] std::uint64_t steps() const {
    if (max_steps > 0) return max_steps;
    return why_no_callgrind().empty() ? 400000 : 30000;  // two minutes, or one
  }
};

TimedInput input_for(const InstructionsOptions& options, std::ostream& log) {
  std::vector<std::string> pictures;
  if (!options.image.empty()) pictures.push_back(options.image);
  TimedInput whole = std::move(timed_inputs({pictures, options.binarise, {}}, &log).front());
  return small_copy(whole);
}

/// The one input in the form that rows are selected by.
std::vector<TimedInput> inputs_for(const InstructionsOptions& options, std::ostream& log) {
  std::vector<TimedInput> inputs;
  inputs.push_back(input_for(options, log));
  return inputs;
}

/// The rows on one thread, verified.
Selection selected(const InstructionsOptions& options, const std::vector<TimedInput>& inputs) {
  Selection selection = select_rows_or_explain({options.filter, VariantChoice::all, {2}, false},
                                               all_operations(), inputs);
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

struct Results {
  nlohmann::ordered_json document;
  std::string table;
  std::size_t skipped;
  std::string why_not_callgrind;
};

Results counted(const InstructionsOptions& options, std::ostream& log) {
  const std::vector<TimedInput> inputs = inputs_for(options, log);
  const Selection selection = selected(options, inputs);
  const RowCounts counts = counts_of(selection.rows, options.steps());
  return {counts_json(inputs.front(), counts, options.steps()), counts_table(counts),
          counts.skipped.size(), counts.callgrind.why_not};
}

void report_skipped(const Results& results, const InstructionsOptions& options,
                    const Console& console) {
  if (!results.why_not_callgrind.empty()) {
    console.err << results.why_not_callgrind << ": rows are counted by single steps instead\n";
  }
  if (results.skipped == 0) return;
  console.err << results.skipped << (results.skipped == 1 ? " row was" : " rows were")
              << " not counted: more than " << options.steps() << " single steps\n";
}

int run(const InstructionsOptions& options, const Console& console) {
  if (!options.out.empty()) check_target(options.out);
  const Results results = counted(options, console.err);
  const std::string json = results.document.dump(1) + "\n";
  if (!options.out.empty()) write_whole_file(options.out, json);
  report_skipped(results, options, console);
  console.out << (options.json ? json : results.table);
  return kSuccess;
}

void add_options(CLI::App& app, InstructionsOptions& options) {
  app.add_option("--filter", options.filter, "Only rows whose name contains a match")
      ->type_name("REGEX");
  CLI::Option* image =
      app.add_option("--image", options.image, "Image to take instead of the scene")
          ->check(not_empty())
          ->type_name("FILE");
  add_binarise_options(app, options.binarise, image);
  app.add_option("--max-steps", options.max_steps,
                 "Skip rows that take more single steps (default: 400000, without valgrind 30000)")
      ->check(whole_number(1, 100000000))
      ->type_name("N");
  app.add_flag("--json", options.json, "Print JSON instead of a table");
  app.add_option("--out", options.out, "Write the data here, as JSON")
      ->check(not_empty())
      ->type_name("FILE");
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
