#include "paired/options.hpp"

#include "cli/arguments.hpp"
#include "cli/binarise_options.hpp"
#include "cli/parse_errors.hpp"

namespace thinbench {
namespace {

void add_choice_of_rows(CLI::App& app, PairedOptions& options) {
  CLI::Option* image =
      app.add_option("--image", options.pictures, "time this image, not the scene (repeatable)");
  add_binarise_options(app, options.binarise, image);
  app.add_option(
      "--filter", options.filter,
      "results whose name case/technique/isa/threads/scope/input matches, see thinbench_timings");
  app.add_flag("--highest-level", options.highest_level, "only the highest ISA of each technique");
  app.add_option("--slowest", options.slowest_ms,
                 "omit rows whose call takes more milliseconds, and cases whose "
                 "reference takes 100 times as much")
      ->check(real_number(0, 1e9))
      ->type_name("MS");
  app.add_flag("--no-peers", options.no_peers, "omit other projects' code and the copy");
}

void add_amounts(CLI::App& app, PairedOptions& options) {
  app.add_option("--processes", options.processes, "fresh processes, the unit of sampling")
      ->capture_default_str()
      ->check(whole_number(1, 99))
      ->type_name("N");
  app.add_option("--first-seed", options.first_seed,
                 "of the order and layout in the first process; the others count on")
      ->capture_default_str()
      ->check(whole_number(0, 1'000'000))
      ->type_name("N");
  app.add_option("--rounds", options.limits.rounds, "at most, in each process")
      ->capture_default_str()
      ->check(whole_number(1, 1001))
      ->type_name("N");
  app.add_option("--seconds-per-pair", options.limits.seconds_per_pair,
                 "in each process; bounds the rounds, of which there are 3 or more")
      ->capture_default_str()
      ->check(real_number(0, 100))
      ->type_name("S");
}

void add_options(CLI::App& app, PairedOptions& options) {
  add_choice_of_rows(app, options);
  add_amounts(app, options);
  app.add_option("--csv-out", options.csv_out, "write ratios with intervals here")
      ->check(not_empty());
  app.add_option("--samples-out", options.samples_out, "write all samples here, as JSON lines")
      ->check(not_empty());
  app.add_flag("--quiet", options.quiet, "no table on standard output");
  app.add_option("--measure-with-seed", options.measure_with_seed)->group("");
  app.footer(
      "The rows of a case on an input are measured beside its fastest, the anchor A, in "
      "epochs\n"
      "of about 0.3 ms: A B A C A ...; calls of more than 1 ms once a round, beside all its "
      "epochs\n"
      "of A. A process gives the median of ln(t / t_A) of each row; the ratio of two is the "
      "median\n"
      "of the difference over fresh processes. Controls: a row against itself, and slowed by\n"
      "10 %. Exit status: 0 done, 1 failure, 2 wrong usage or a row that is not equal to its\n"
      "reference, 3 inconclusive, as a control failed.\n"
      "Examples:\n"
      "  thinbench_paired --filter '^thin_guo_hall/.*bitpacked' --csv-out speedups.csv\n"
      "  thinbench_paired --image horse.png --highest-level --processes 3\n"
      "  thinbench_paired --slowest 1 --seconds-per-pair 0.1 --samples-out samples.jsonl");
}

}  // namespace

bool parse_options(const std::vector<std::string>& arguments, PairedOptions& options) {
  CLI::App app("Speed-ups over the references, measured in pairs by fresh processes",
               "thinbench_paired");
  add_options(app, options);
  return parse_or_help(app, arguments);
}

}  // namespace thinbench
