#include "timing/options.hpp"

#include "cli/arguments.hpp"
#include "cli/binarise_options.hpp"
#include "cli/parse_errors.hpp"

namespace thinbench {
namespace {

void add_options(CLI::App& app, TimingOptions& options) {
  CLI::Option* image = app.add_option("--image", options.inputs.pictures,
                                      "time this image, not the scene (repeatable)");
  add_binarise_options(app, options.inputs.binarise, image);
  app.add_option("--filter", options.filter,
                 "results whose name case/technique/isa/threads/scope/input matches");
  app.add_option("--largest-square", options.inputs.largest_square,
                 "where the series of sizes ends; 0 for none")
      ->capture_default_str()
      ->check(whole_number(0, 16384))
      ->type_name("N");
  app.add_option("--repetitions", options.repetitions, "of every row, interleaved at random")
      ->capture_default_str()
      ->check(whole_number(1, 1000))
      ->type_name("N");
  app.add_option("--seconds", options.seconds, "a repetition lasts about as long")
      ->capture_default_str()
      ->check(real_number(0, 10))
      ->type_name("S");
  app.add_option("--rows-out", options.rows_out, "write inputs and skipped rows here, as JSON")
      ->check(not_empty());
  app.add_option("--pictures-out", options.pictures_out,
                 "write inputs and results to this directory")
      ->check(not_empty());
  app.add_flag("--highest-level", options.highest_level, "only the highest ISA of each technique");
  app.add_flag("--no-peers", options.no_peers, "omit other projects' code and the copy");
  app.add_flag("--quiet", options.quiet, "no table on standard output");
  app.footer(
      "A case is an operation, with ':keep' where the image border is kept and ':N' for at most N\n"
      "iterations. Of the cases that keep the border only those of OpenCV's rules are timed; name\n"
      "another in the filter: --filter '^thin_mb2:keep/'.\n"
      "Options that start with --benchmark_ go to Google Benchmark, such as\n"
      "  --benchmark_out=timings.json --benchmark_out_format=json\n"
      "Examples:\n"
      "  thinbench_timings --filter 'bitpacked.*/scene'\n"
      "  thinbench_timings --image horse.png --largest-square 0\n"
      "  thinbench_timings --image parts.jpg --foreground dark --threshold 100");
}

}  // namespace

bool parse_options(int count, char** arguments, TimingOptions& options) {
  CLI::App app("Time every operation, each variant verified against its reference first",
               "thinbench_timings");
  add_options(app, options);
  return parse_or_help(app, {arguments + 1, arguments + count});
}

}  // namespace thinbench
