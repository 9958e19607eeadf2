// thinbench_benchmarks: verifies rows and measures them with Google Benchmark. `./study` starts it;
// see docs/measuring.md.
#include <algorithm>
#include <climits>
#include <deque>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <string_view>

#include <CLI/CLI.hpp>
#include <benchmark/benchmark.h>
#if __has_include(<malloc.h>)
#include <malloc.h>
#endif
#include <nlohmann/json.hpp>

#include "cli/arguments.hpp"
#include "cli/parse_errors.hpp"
#include "cli/reported.hpp"
#include "measure/build_facts.hpp"
#include "measure/known_rows.hpp"
#include "measure/pictures.hpp"
#include "measure/repetition.hpp"
#include "measure/row_options.hpp"
#include "measure/sample_reporter.hpp"
#include "peers/peers.hpp"
#include "support/json_field.hpp"
#include "support/usage.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

struct BenchmarkOptions {
  InputChoice inputs;
  RowChoice rows;
  double max_call_seconds = 1;
  double seconds_per_row = 0.01;
  std::string facts;
  std::string known;
  std::string samples;
  std::string pictures;
  bool machine = false;
  bool are_checked = false;  // results, by an earlier process
  bool for_people = true;
};

/// Of the project's rows on one thread in a group, which the controls repeat.
bool can_be_control(const KnownRow& known) {
  return known.row.variant != nullptr && !known.row.is_peer() && known.row.threads == 1;
}

/// By hand there is one process, whose median is shown; `./study` starts many, the shorter the
/// better: neighbours come and go within seconds.
constexpr int kMinRepetitions = 4;

/// Benchmarks that are registered, with what they need while they run.
class Registered {
 public:
  explicit Registered(const BenchmarkOptions& options)
      : seconds_per_row_(options.seconds_per_row),
        are_checked_(options.are_checked),
        min_repetitions_(options.known.empty() ? kMinRepetitions : 1) {}

  /// Rows, and two controls for each case and input.
  void add_all(const std::vector<KnownRow>& rows) {
    std::map<std::pair<const Operation*, const TimedInput*>, const KnownRow*> fastest;
    for (const KnownRow& known : rows) {
      add(known, "", 0);
      const KnownRow*& best = fastest[{known.row.operation, known.row.input}];
      if (can_be_control(known) && (best == nullptr || known.seconds < best->seconds)) {
        best = &known;
      }
    }
    constexpr double kSlowdown = 0.1;
    for (const auto& [group, best] : fastest) {
      if (best == nullptr) continue;
      add(*best, "/again", 0);
      add(*best, "/slowed", kSlowdown * 1e9 * best->seconds);
    }
  }

 private:
  void add(const KnownRow& known, const char* suffix, double delay_ns) {
    Measured& measured = measured_.emplace_back(known, seconds_per_row_, min_repetitions_);
    measured.delay_ns = delay_ns;
    measured.is_checked = are_checked_;
    const std::string name = known.row.name + suffix;
    benchmark::RegisterBenchmark(name.c_str(), [this, &measured](benchmark::State& state) {
      repeat(state, measured, workspaces_);
      add_counters(state, measured.known.row);
    })->Repetitions(measured.repetitions);
  }

  static void add_counters(benchmark::State& state, const TimedRow& row) {
    const auto pixels = static_cast<double>(row.input->width() * row.input->height());
    state.counters["pixels_per_second"] =
        benchmark::Counter(pixels, benchmark::Counter::kIsIterationInvariantRate);
    if (row.iterations) {
      state.counters["thinning_iterations"] = static_cast<double>(*row.iterations);
    }
  }

  double seconds_per_row_;
  bool are_checked_;
  int min_repetitions_;
  std::deque<Measured> measured_;
  Workspaces workspaces_;
};

int measure(const std::vector<KnownRow>& rows, const BenchmarkOptions& options) {
  Registered registered(options);
  registered.add_all(rows);
  SampleReporter reporter(options.samples, options.for_people);
  const std::size_t count = benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::ClearRegisteredBenchmarks();
  if (count == 0) return kUsage;
  return reporter.has_failed() ? kFailure : kSuccess;
}

int verify_and_measure(const BenchmarkOptions& options) {
  const std::vector<TimedInput> inputs = timed_inputs(options.inputs, &std::cerr);
  Selection selection = select_rows_or_explain(options.rows, operations_with_peers(), inputs);
  const std::vector<KnownRow> rows = calibrate_rows(selection, options.max_call_seconds);
  const int status = selection.mismatches.empty() ? kSuccess : kUsage;
  if (!options.facts.empty()) {
    write_whole_file(options.facts, json_line(facts_json(options.inputs, inputs, selection, rows)));
    return status;
  }
  report_skipped(selection);
  return std::max(status, measure(rows, options));
}

int run(const BenchmarkOptions& options) {
  if (options.machine) {
    std::cout << build_facts().dump(2) << '\n';
    return kSuccess;
  }
  if (!options.pictures.empty()) {
    write_pictures(timed_inputs(options.inputs, &std::cerr), options.pictures);
    return kSuccess;
  }
  if (options.known.empty()) return verify_and_measure(options);
  const Known known(options.known, operations_with_peers());
  return measure(known.rows, options);
}

/// The value of an option of Google Benchmark that was given.
std::optional<std::string> value_of(const std::vector<std::string>& words,
                                    const std::string& option) {
  const auto found = std::find_if(words.rbegin(), words.rend(), [&](const std::string& word) {
    return word.starts_with(option + "=");
  });
  if (found == words.rend()) return std::nullopt;
  return found->substr(option.size() + 1);
}

bool asks_for_help(const std::vector<std::string>& words) {
  return std::any_of(words.begin(), words.end(),
                     [](const std::string_view word) { return word == "--help" || word == "-h"; });
}

/// Google Benchmark ends names by the number of repetitions, before a filter looks at them.
void let_filter_end(std::string& word) {
  if (word.starts_with("--benchmark_filter=") && word.ends_with('$')) {
    word.insert(word.size() - 1, "/repeats:[0-9]*");
  }
}

/// Google Benchmark takes its options out of the words, and would print its own help. With the
/// shortest time that it knows, a repetition is one batch of calls.
void initialize(std::vector<std::string>& words) {
  if (asks_for_help(words)) return;
  std::for_each(words.begin(), words.end(), let_filter_end);
  words.insert(words.begin() + 1,
               {"--benchmark_enable_random_interleaving=true", "--benchmark_min_time=1e-9"});
  std::vector<char*> arguments;
  arguments.reserve(words.size());
  for (std::string& word : words) arguments.push_back(word.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  benchmark::BenchmarkReporter::Context::executable_name = "thinbench_benchmarks";
  words = {arguments.data(), arguments.data() + count};
}

void add_options(CLI::App& app, BenchmarkOptions& options) {
  add_row_options(app, options.inputs, options.rows);
  add_value(app, "--seconds-per-row", options.seconds_per_row,
            "how long the repetitions of a row take, about; there are 4 to 25, with --known 1 "
            "to 25",
            real_number(0, 100), "S")
      ->capture_default_str();
  add_value(app, "--max-call", options.max_call_seconds,
            "rows whose call takes longer are verified, but not measured", real_number(0, 1e6), "S")
      ->capture_default_str();
  add_file_option(app, "--samples", options.samples, "write a line of CSV for each repetition");
  CLI::Option* facts =
      add_file_option(app, "--facts", options.facts,
                      "only verify; write what is known of the rows as JSON, for --known");
  CLI::Option* known =
      add_file_option(
          app, "--known", options.known,
          "measure the rows of these facts, which are not verified again: their results "
          "must be the verified ones")
          ->excludes(facts);
  app.add_flag(
         "--checked", options.are_checked,
         "an earlier process has compared the results, which takes longer than to compute them "
         "where images are large")
      ->needs(known);
  add_value(app, "--pictures", options.pictures,
            "only write the inputs and what operations make of them as image files", not_empty(),
            "DIR");
  app.add_flag("--machine", options.machine,
               "only describe the build as JSON, for ./study, which adds the machine");
  app.footer(
      R"(Every row is verified against its reference before it is measured. A repetition is about 0.3 ms of
calls, or one longer call, of a new job; repetitions of all rows are interleaved. ROW/again and
ROW/slowed are controls: the fastest row of each case once more, and with a delay of a tenth. Shown
is the median of the repetitions. Options that start with --benchmark_ go to Google Benchmark;
--benchmark_filter also chooses what is verified, unless --filter does.

Examples:
  thinbench_benchmarks --benchmark_filter='^thin_guo_hall/.*bitpacked'
  thinbench_benchmarks --variants best --benchmark_format=csv > times.csv
  thinbench_benchmarks --image parts.jpg --foreground dark --threshold 100
  thinbench_benchmarks --pictures out --image parts.jpg

Exit status: 0 done, 1 a row failed, 2 wrong usage or a row that differs from its reference.)");
}

/// Else large blocks that references and peers allocate would come from the system at each call or
/// at none, as what else the process did decides, and new pages take longer than many calls.
void keep_freed_memory() {
#ifdef M_MMAP_MAX
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, INT_MAX);
#endif
}

int run(std::vector<std::string> words) {
  keep_freed_memory();
  BenchmarkOptions options;
  options.for_people = value_of(words, "--benchmark_format").value_or("console") == "console";
  const std::string filter = value_of(words, "--benchmark_filter").value_or("");
  initialize(words);
  CLI::App app("Verify rows and measure them with Google Benchmark", "thinbench_benchmarks");
  add_options(app, options);
  if (!parse_or_help(app, {words.begin() + 1, words.end()}, std::cout)) return kSuccess;
  if (options.rows.filter.empty() && !filter.starts_with('-') && filter != "all") {
    options.rows.filter = filter;
  }
  return run(options);
}

}  // namespace
}  // namespace thinbench

int main(int argc, char** argv) {
  return thinbench::run_and_report("thinbench_benchmarks", std::cout, std::cerr, [&] {
    return thinbench::run({argv, argv + argc});
  });
}
