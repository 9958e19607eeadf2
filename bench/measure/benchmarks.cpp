// The rows under Google Benchmark, for people who run benchmarks by hand. What is published comes
// from the sampler.
#include <algorithm>
#include <iostream>
#include <string_view>

#include <CLI/CLI.hpp>
#include <benchmark/benchmark.h>

#include "cli/parse_errors.hpp"
#include "cli/reported.hpp"
#include "cli/usage.hpp"
#include "measure/row_options.hpp"
#include "measure/timed_call.hpp"
#include "peers/peers.hpp"

namespace thinbench {
namespace {

struct BenchmarkOptions {
  InputChoice inputs;
  RowChoice rows;
};

void run_row(benchmark::State& state, const TimedRow& row) {
  TimedCall call(row);
  call();  // touches every page
  for (auto _ : state) {
    call();
    benchmark::ClobberMemory();
  }
  const auto pixels = static_cast<double>(row.input->width() * row.input->height());
  state.counters["pixels_per_second"] =
      benchmark::Counter(pixels, benchmark::Counter::kIsIterationInvariantRate);
  if (row.counter) {
    state.counters[std::string(row.operation->counter)] = static_cast<double>(*row.counter);
  }
}

int run(const BenchmarkOptions& options) {
  const std::vector<TimedInput> inputs = timed_inputs(options.inputs, &std::cerr);
  const Selection selection = select_rows_or_explain(options.rows, operations_with_peers(), inputs);
  report_skipped(selection);
  for (const TimedRow& row : selection.rows) {
    auto* registered = benchmark::RegisterBenchmark(
        row.name.c_str(), [&row](benchmark::State& state) { run_row(state, row); });
    if (row.threads > 1) registered->UseRealTime();
  }
  const std::size_t count = benchmark::RunSpecifiedBenchmarks();
  return count > 0 && selection.mismatches.empty() ? kSuccess : kUsage;
}

bool asks_for_help(const std::vector<char*>& arguments) {
  return std::any_of(arguments.begin(), arguments.end(),
                     [](const std::string_view word) { return word == "--help" || word == "-h"; });
}

/// Google Benchmark would print its own help; else it takes its options out of `arguments`.
void initialize(std::vector<char*>& arguments) {
  if (asks_for_help(arguments)) return;
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  arguments.resize(static_cast<std::size_t>(count));
}

int run(std::vector<char*> arguments) {
  initialize(arguments);
  BenchmarkOptions options;
  CLI::App app("Time every operation with Google Benchmark, each variant verified first",
               "thinbench_benchmarks");
  add_row_options(app, options.inputs, options.rows);
  app.footer(
      "Options that start with --benchmark_ go to Google Benchmark. --filter chooses the rows "
      "that\n"
      "are verified and registered, --benchmark_filter those of them that run.\n"
      "Examples:\n"
      "  thinbench_benchmarks --filter '^thin_guo_hall/.*bitpacked'\n"
      "  thinbench_benchmarks --variants best --benchmark_format=csv\n"
      "  thinbench_benchmarks --image parts.jpg --foreground dark --threshold 100");
  if (!parse_or_help(app, {arguments.begin() + 1, arguments.end()})) return kSuccess;
  return run(options);
}

}  // namespace
}  // namespace thinbench

int main(int argc, char** argv) {
  return thinbench::run_and_report("thinbench_benchmarks", std::cout, std::cerr, [&] {
    return thinbench::run({argv, argv + argc});
  });
}
