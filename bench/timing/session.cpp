#include "timing/session.hpp"

#include <algorithm>
#include <iostream>
#include <set>

#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "peers/peers.hpp"
#include "picture/binarise.hpp"
#include "picture/picture.hpp"
#include "support/whole_file.hpp"
#include "timing/inputs.hpp"
#include "timing/options.hpp"
#include "timing/progress.hpp"
#include "timing/row_selection.hpp"
#include "timing/schedule.hpp"
#include "timing/timed_call.hpp"
#include "timing/timed_row.hpp"

namespace thinbench {
namespace {

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

/// The peers among the variants, by technique.
std::set<std::string_view> peer_techniques(const std::vector<Operation>& operations) {
  std::set<std::string_view> techniques;
  for (const Operation& operation : operations) {
    for (const Variant& variant : operation.variants) {
      if (variant.is_peer) techniques.insert(variant.technique);
    }
  }
  return techniques;
}

/// Operating systems differ in what they make of a colon.
std::string file_stem(const Operation& operation) {
  std::string stem = operation.name;
  std::replace(stem.begin(), stem.end(), ':', '_');
  return stem;
}

nlohmann::json rows_json(const Selection& selection, const std::vector<TimedInput>& inputs,
                         const std::set<std::string_view>& techniques) {
  nlohmann::json json = {{"schema", 1},
                         {"inputs", nlohmann::json::array()},
                         {"peers", nlohmann::json::array()},
                         {"skipped", nlohmann::json::array()},
                         {"verified", selection.verified},
                         {"failed", selection.mismatches.size()}};
  for (const TimedInput& input : inputs) {
    json["inputs"].push_back({{"name", input.name},
                              {"width", input.width()},
                              {"height", input.height()},
                              {"hash", pixel_hash(input.binary.view())},
                              {"grey_hash", pixel_hash(input.grey.view())},
                              {"object_pixels", foreground_pixels(input.binary.view())}});
  }
  for (const Peer& peer : peers()) {
    if (techniques.count(peer.technique) == 0) continue;
    json["peers"].push_back({{"technique", peer.technique},
                             {"about", peer.about},
                             {"equal_output", peer.equal_output}});
  }
  for (const SkippedRow& row : selection.skipped) {
    json["skipped"].push_back({{"row", row.name}, {"reason", row.reason}});
  }
  return json;
}

void write_pictures(const std::string& folder, const Selection& selection) {
  for (const TimedRow& row : selection.rows) {
    // Nets learned the rule: their images would be the rule's again.
    if (row.variant != nullptr || row.input->size_sweep || row.operation->is_net) continue;
    const ConstImageView input = row.input->view(row.operation->takes);
    const std::string stem = folder + "/" + row.input->name;
    write_grey(stem + (row.operation->takes == InputKind::grey ? "_grey.png" : ".png"), input);
    const auto reference = row.operation->reference(input.width, input.height, 1);
    if (!reference->gives_image()) continue;
    write_grey(stem + "_" + file_stem(*row.operation) + ".png",
               outcome_of(*reference, input).image.view());
  }
}

/// Beside the times. Google Benchmark has a field "iterations" of its own, the timed calls, so the
/// iterations of thinning are "counted_iterations"; the border is the label, as counters are
/// numbers.
void add_facts(benchmark::State& state, const TimedRow& row) {
  state.counters["width"] = static_cast<double>(row.input->width());
  state.counters["height"] = static_cast<double>(row.input->height());
  if (row.counter) {
    state.counters["counted_" + std::string(row.operation->counter)] =
        static_cast<double>(*row.counter);
  }
  const CaseLabels labels = row.operation->labels();
  if (!labels.border.empty()) state.SetLabel(labels.border);
  if (labels.max_iterations) state.counters["max_iterations"] = *labels.max_iterations;
  if (row.plan_bytes) state.counters["plan_bytes"] = static_cast<double>(*row.plan_bytes);
  if (row.variant != nullptr && row.variant->is_peer) state.counters["peer"] = 1;
  state.counters["verified"] = 1;
}

void run_row(benchmark::State& state, const TimedRow& row, bool warm_up) {
  TimedCall call(row);
  if (warm_up) call();  // touches every page first
  for (auto _ : state) {
    call();
    benchmark::ClobberMemory();
  }
  add_facts(state, row);
}

/// Registers all rows; returns the seconds that they will take.
double register_rows(const std::vector<TimedRow>& rows, const TimingOptions& options,
                     std::unique_ptr<Progress>& progress) {
  double total = 0;
  for (const TimedRow& row : rows) {
    const Schedule schedule =
        schedule_of(seconds_of_one_call(row), options.repetitions, options.seconds);
    const bool warm_up = schedule.warm_up;
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

int run(const TimingOptions& options, const std::vector<Operation>& operations) {
  if (!options.rows_out.empty()) check_target(options.rows_out);
  InputChoice choice = options.inputs;
  choice.log = &std::cerr;
  const std::vector<TimedInput> inputs = timed_inputs(choice);
  const Selection selection = rows_asked_for(
      options.filter, operations, inputs, options.highest_level ? Levels::highest : Levels::all);
  if (!options.rows_out.empty()) {
    write_whole_file(options.rows_out,
                     rows_json(selection, inputs, peer_techniques(operations)).dump(2));
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
  return good ? kSuccess : kUsage;
}

/// Google Benchmark would print its own help and end the program.
bool asks_for_help(const std::vector<char*>& arguments) {
  return std::any_of(arguments.begin(), arguments.end(),
                     [](const std::string_view word) { return word == "--help" || word == "-h"; });
}

/// Hands the options of Google Benchmark over; the rest stays in `arguments`.
int initialize(std::vector<char*>& arguments) {
  // Ours first, so that the user's own --benchmark_ options win.
  static std::string interleaving = "--benchmark_enable_random_interleaving=true";
  arguments.insert(arguments.begin() + 1, interleaving.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  return count;
}

}  // namespace

int run_timings(std::vector<char*> arguments, const std::vector<Operation>& operations) {
  try {
    const int count =
        asks_for_help(arguments) ? static_cast<int>(arguments.size()) : initialize(arguments);
    TimingOptions options;
    if (!parse_options(count, arguments.data(), options)) return kSuccess;
    return options.no_peers ? run(options, without_peers(operations)) : run(options, operations);
  } catch (const UsageError& error) {
    std::cerr << "thinbench_timings: " << error.what() << '\n';
    return kUsage;
  } catch (const std::exception& error) {
    std::cerr << "thinbench_timings: " << error.what() << '\n';
    return kFailure;
  }
}

}  // namespace thinbench
