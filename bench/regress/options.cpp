#include "regress/options.hpp"

#include "cli/arguments.hpp"
#include "cli/parse_errors.hpp"

namespace thinbench {
namespace {

void add_compare(CLI::App& program, RegressOptions& options) {
  CLI::App* app = program.add_subcommand("compare", "Give a verdict on a run");
  app->add_option("--run", options.run, "samples of this run (repeatable)")->required();
  app->add_option("--again", options.again, "samples of rows that were measured again");
  auto* baselines =
      app->add_option("--baselines", options.baselines, "folder with what to compare with");
  auto* old = app->add_option("--old", options.old,
                              "samples of another build, measured by turns with --run");
  app->add_option("--old-again", options.old_again, "and those measured by turns with --again");
  old->excludes(baselines);
  app->add_option("--rerun-out", options.rerun_out,
                  "write here which cases have to be measured again, as A|B|C")
      ->check(not_empty());
  app->add_flag("--judge-threads", options.judge_threads,
                "judge rows with threads, too: only where no one else uses the cores");
  app->add_flag("--all", options.all, "show rows that passed, too");
}

void add_update(CLI::App& program, RegressOptions& options) {
  CLI::App* app = program.add_subcommand("update", "Make a run the baseline");
  app->add_option("--run", options.run, "samples (repeatable)")->required();
  app->add_option("--baselines", options.baselines, "folder to write it to")
      ->required()
      ->check(not_empty());
  app->add_option("--reason", options.reason, "why, for the history")
      ->required()
      ->check(not_empty());
  app->add_option("--commit", options.commit, "what was measured")->required()->check(not_empty());
}

void add_counts_file(CLI::App& program, RegressOptions& options) {
  CLI::App* app = program.add_subcommand(
      "counts-file", "Print where the counts of instructions beside the baseline belong");
  app->add_option("--baselines", options.baselines, "folder with baselines")
      ->required()
      ->check(not_empty());
}

}  // namespace

bool parse_options(const std::vector<std::string>& arguments, RegressOptions& options) {
  CLI::App app("Did rows become slower?", "thinbench_regress");
  add_compare(app, options);
  add_update(app, options);
  add_counts_file(app, options);
  app.require_subcommand(1);
  app.footer(
      "Exit status: 0 PASS, 1 FAIL, 2 wrong usage or a failure, 3 INCONCLUSIVE, 4 nothing was\n"
      "compared.\n"
      "Examples:\n"
      "  thinbench_regress compare --run samples.jsonl --baselines results/baselines\n"
      "  thinbench_regress compare --run new.jsonl --old old.jsonl --all\n"
      "  thinbench_regress update --run samples.jsonl --baselines results/baselines \\\n"
      "      --commit 0123456789 --reason 'first baseline'\n"
      "  thinbench_regress counts-file --baselines results/baselines");
  if (!parse_or_help(app, arguments)) return false;
  options.update = app.got_subcommand("update");
  options.counts_file = app.got_subcommand("counts-file");
  return true;
}

}  // namespace thinbench
