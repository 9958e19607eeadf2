// Times every row of the tables with Google Benchmark, each only after its output was compared
// with the reference's on the very input that is timed.
#include <iostream>
#include <map>

#include <CLI/CLI.hpp>
#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>

#include "picture/objects.hpp"
#include "picture/picture.hpp"
#include "support/whole_file.hpp"
#include "timing/inputs.hpp"
#include "timing/progress.hpp"
#include "timing/timed_call.hpp"
#include "timing/timed_row.hpp"

namespace thinbench {
namespace {

constexpr int kExitBadRow = 2;  // nothing ran, or a row was not equal to its reference

struct Options {
  InputChoice inputs;
  std::string filter;
  std::string rows_out;
  std::string pictures_out;
  int repetitions = 15;
  double seconds = 0.03;  // a repetition
  bool quiet = false;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("--image", options.inputs.pictures,
                 "time this picture, not the scene (repeatable)");
  app.add_option("--filter", options.filter,
                 "rows whose name operation/technique/isa/threads/scope/input matches");
  app.add_option("--largest-square", options.inputs.largest_square,
                 "where the series of sizes ends; 0 for none")
      ->capture_default_str()
      ->check(CLI::Range(0, 16384));
  app.add_option("--repetitions", options.repetitions, "of every row, interleaved at random")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_option("--seconds", options.seconds, "a repetition lasts about as long")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 10.0));
  app.add_option("--rows-out", options.rows_out, "write inputs and skipped rows here, as JSON");
  app.add_option("--pictures-out", options.pictures_out, "write inputs and results to this folder");
  app.add_flag("--quiet", options.quiet, "no table on standard output");
  app.footer(
      "Options that start with --benchmark_ go to Google Benchmark, such as\n"
      "  --benchmark_out=timings.json --benchmark_out_format=json\n"
      "Examples:\n"
      "  thinbench_timings --filter 'bitpacked.*/scene'\n"
      "  thinbench_timings --image horse.png --largest-square 0");
}

/// Shows what Google Benchmark reports, unless quiet, and counts it.
class CountingReporter : public benchmark::ConsoleReporter {
 public:
  explicit CountingReporter(bool quiet) : ConsoleReporter(OO_Tabular), quiet_(quiet) {}

  bool ReportContext(const Context& context) override {
    return quiet_ || ConsoleReporter::ReportContext(context);
  }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) failed_ += run.error_occurred ? 1 : 0;
    if (!quiet_) ConsoleReporter::ReportRuns(runs);
  }
  void Finalize() override {
    if (!quiet_) ConsoleReporter::Finalize();
  }
  [[nodiscard]] int failed() const { return failed_; }

 private:
  bool quiet_;
  int failed_ = 0;
};

nlohmann::json rows_json(const Selection& selection, const std::vector<TimedInput>& inputs) {
  nlohmann::json json = {{"schema", 1},
                         {"inputs", nlohmann::json::array()},
                         {"skipped", nlohmann::json::array()},
                         {"verified", selection.verified},
                         {"failed", selection.mismatches.size()}};
  for (const TimedInput& input : inputs) {
    json["inputs"].push_back({{"name", input.name},
                              {"width", input.width()},
                              {"height", input.height()},
                              {"hash", pixel_hash(input.binary.view())},
                              {"grey_hash", pixel_hash(input.grey.view())},
                              {"object_pixels", object_pixels(input.binary.view())}});
  }
  for (const SkippedRow& row : selection.skipped) {
    json["skipped"].push_back({{"row", row.name}, {"reason", row.reason}});
  }
  return json;
}

void write_pictures(const std::string& folder, const Selection& selection) {
  for (const TimedRow& row : selection.rows) {
    // Nets learned the rule: their pictures would be the rule's again.
    if (row.variant != nullptr || row.input->size_sweep || row.operation->is_net) continue;
    const ConstByteView input = row.input->view(row.operation->takes);
    const std::string stem = folder + "/" + row.input->name;
    write_grey(stem + (row.operation->takes == InputKind::kGrey ? "_grey.png" : ".png"), input);
    const auto reference = row.operation->reference(input.width, input.height, 1);
    if (!reference->gives_image()) continue;
    write_grey(stem + "_" + row.operation->name + ".png",
               outcome_of(*reference, input).image.view());
  }
}

void run_row(benchmark::State& state, const TimedRow& row, bool warm_up) {
  TimedCall call(row);
  if (warm_up) call();  // touches every page first
  for (auto _ : state) {
    call();
    benchmark::ClobberMemory();
  }
  state.counters["width"] = static_cast<double>(row.input->width());
  state.counters["height"] = static_cast<double>(row.input->height());
  if (row.counter) {
    state.counters[std::string(row.operation->counter)] = static_cast<double>(*row.counter);
  }
  if (row.variant != nullptr && row.variant->is_peer) state.counters["peer"] = 1;
  state.counters["verified"] = 1;
}

/// How often a row runs: iterations a repetition, repetitions, and the seconds that all of it
/// takes.
struct Schedule {
  std::int64_t iterations;
  int repetitions;
  double seconds_a_repetition;
};

Schedule schedule_of(const TimedRow& row, const Options& options) {
  const double one = std::max(seconds_of_one_call(row), 1e-7);
  if (one > kSlowCall) {
    const auto iterations = std::max<std::int64_t>(1, std::llround(options.seconds / one));
    const int repetitions = std::max(3, options.repetitions / 3);
    return {iterations, repetitions, static_cast<double>(iterations) * one};
  }
  const auto iterations = std::max<std::int64_t>(1, std::llround(options.seconds / one));
  return {iterations, options.repetitions, static_cast<double>(iterations + 1) * one};
}

/// Registers all rows; returns the seconds that they will take.
double register_rows(const std::vector<TimedRow>& rows, const Options& options,
                     std::unique_ptr<Progress>& progress) {
  double total = 0;
  for (const TimedRow& row : rows) {
    const Schedule schedule = schedule_of(row, options);
    const bool warm_up = schedule.repetitions == options.repetitions;
    const double share = schedule.seconds_a_repetition;
    auto* registered = benchmark::RegisterBenchmark(
        row.name.c_str(), [&row, warm_up, share, &progress](benchmark::State& state) {
          run_row(state, row, warm_up);
          progress->advance(share);
        });
    registered->Iterations(schedule.iterations)->Repetitions(schedule.repetitions);
    registered->Unit(benchmark::kNanosecond);
    if (row.threads > 1) registered->MeasureProcessCPUTime()->UseRealTime();
    total += share * schedule.repetitions;
  }
  return total;
}

void report_selection(const Selection& selection) {
  for (const std::string& mismatch : selection.mismatches) {
    std::cerr << "not equal to the reference, not timed: " << mismatch << '\n';
  }
  if (!selection.skipped.empty()) {
    std::cerr << "rows skipped: ";
    std::map<std::string, int> reasons;
    for (const SkippedRow& row : selection.skipped) ++reasons[row.reason];
    const char* separator = "";
    for (const auto& [reason, count] : reasons) {
      std::cerr << separator << count << " (" << reason << ')';
      separator = ", ";
    }
    std::cerr << '\n';
  }
}

int run(const Options& options) {
  const std::vector<TimedInput> inputs = timed_inputs(options.inputs);
  const Selection selection = select_rows(options.filter, all_operations(), inputs);
  report_selection(selection);
  if (selection.rows.empty()) {
    std::cerr << "thinbench_timings: no row to time; the filter is '" << options.filter << "'\n";
    return kExitBadRow;
  }
  if (!options.rows_out.empty()) {
    write_whole_file(options.rows_out, rows_json(selection, inputs).dump(2));
  }
  if (!options.pictures_out.empty()) write_pictures(options.pictures_out, selection);

  std::unique_ptr<Progress> progress;
  const double expected = register_rows(selection.rows, options, progress);
  std::cerr << selection.verified << " variants equal to the reference; timing "
            << selection.rows.size() << " rows, about " << std::lround(expected) << " s\n";
  progress = std::make_unique<Progress>("timing", expected);
  CountingReporter reporter(options.quiet);
  const std::size_t count = benchmark::RunSpecifiedBenchmarks(&reporter);
  progress.reset();
  const bool good = count > 0 && reporter.failed() == 0 && selection.mismatches.empty();
  return good ? 0 : kExitBadRow;
}

}  // namespace
}  // namespace thinbench

int main(int argc, char** argv) {
  // Ours first, so that the user's own --benchmark_ options win.
  std::vector<char*> arguments(argv, argv + argc);
  std::string interleaving = "--benchmark_enable_random_interleaving=true";
  arguments.insert(arguments.begin() + 1, interleaving.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());

  CLI::App app("Time every operation, each way proved equal to its reference first");
  thinbench::Options options;
  thinbench::add_options(app, options);
  CLI11_PARSE(app, count, arguments.data());
  benchmark::AddCustomContext("thinbench_build_type", THINBENCH_BUILD_TYPE);
  try {
    return thinbench::run(options);
  } catch (const std::exception& error) {
    std::cerr << "thinbench_timings: " << error.what() << '\n';
    return 1;
  }
}
