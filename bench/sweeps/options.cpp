#include "sweeps/options.hpp"

#include "cli/arguments.hpp"
#include "cli/names.hpp"
#include "cli/parse_errors.hpp"
#include "support/text.hpp"
#include "sweeps/plan.hpp"

namespace thinbench {
namespace {

CLI::Validator name_of_sweep() {
  const auto check = [](std::string& text) -> std::string {
    std::vector<std::string> names;
    for (const SweepInfo& info : all_sweeps()) {
      if (info.name == text) return {};
      names.emplace_back(info.name);
    }
    return "there is no sweep '" + text + "'; choose from " + joined(names, ", ");
  };
  return {check, ""};
}

std::string footer() {
  std::string text = "Sweeps:\n";
  for (const SweepInfo& info : all_sweeps()) {
    std::string name(info.name);
    name.resize(9, ' ');
    text += "  " + name + std::string(info.about) + "\n";
  }
  return text +
         "Every row is verified on every input before it is timed, against its reference or, "
         "where\n"
         "that would take long, another row, which the journal names. Ctrl-C leaves a journal "
         "that\n"
         "--resume completes. Exit status: 0 done, 1 failure, 2 wrong usage or a row that is not\n"
         "equal to its reference, 130 interrupted.\n"
         "Examples:\n"
         "  thinbench_sweeps --out sweeps.jsonl\n"
         "  thinbench_sweeps --only density --only size --quick --out sweeps.jsonl\n"
         "  thinbench_sweeps --resume sweeps.jsonl";
}

void add_options(CLI::App& app, SweepOptions& options) {
  app.add_option("--only", options.only, "this sweep, not all (repeatable)")
      ->check(name_of_sweep())
      ->type_name("NAME");
  app.add_option("--filter", options.filter, "rows whose name case/technique/isa/threads matches");
  app.add_flag("--quick", options.quick, "smaller images and coarser steps");
  app.add_option("--rounds", options.rounds, "samples of every point")
      ->capture_default_str()
      ->check(whole_number(1, 999))
      ->type_name("N");
  app.add_option("--stop-after", options.stop_after,
                 "stop when every point has N samples, to be resumed: builds by turns")
      ->check(whole_number(1, 999))
      ->type_name("N");
  app.add_option("--seed", options.seed, "of the order")
      ->capture_default_str()
      ->check(whole_number(0, 1'000'000))
      ->type_name("N");
  app.add_option("--commit", options.commit, "to name in the journal")->check(not_empty());
  auto* out = app.add_option("--out", options.out, "begin this journal (JSON lines)");
  auto* resume = app.add_option("--resume", options.resume, "go on with this journal");
  out->check(not_empty())->excludes(resume)->type_name("FILE");
  resume->check(not_empty())->type_name("FILE");
}

}  // namespace

bool parse_options(const std::vector<std::string>& arguments, SweepOptions& options) {
  CLI::App app("How times depend on density, size, threads, depth and ISA", "thinbench_sweeps");
  add_options(app, options);
  app.footer(footer());
  return parse_or_help(app, arguments);
}

}  // namespace thinbench
