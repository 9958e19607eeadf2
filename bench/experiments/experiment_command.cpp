#include "experiments/experiment_command.hpp"

#include <memory>

#include <CLI/CLI.hpp>

#include "experiments/hidden_neurons.hpp"
#include "experiments/operation_counts.hpp"
#include "experiments/quantisation.hpp"
#include "experiments/table_2.hpp"
#include "training/text.hpp"

namespace thinbench {
namespace {

struct Options {
  std::string out;
  bool quick = false;
};

ExperimentReport hidden_neurons(bool quick, std::ostream& err) {
  const HiddenNeuronsChoice choice = quick ? HiddenNeuronsChoice::quick() : HiddenNeuronsChoice{};
  const auto progress = [&err](double done) {
    err << "hidden neurons: " << fixed(done * 100, 0) << " %\n" << std::flush;
  };
  return hidden_neurons_report(run_hidden_neurons(choice, progress), choice);
}

/// Adds one experiment; `run` makes its report, told whether to be quick.
template <class Run>
void add_experiment(CLI::App& parent, const char* name, const char* what, std::ostream& out,
                    std::ostream& err, const Run& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = parent.add_subcommand(name, what);
  command->add_option("--out", options->out, "write the data here, as JSON");
  command->add_flag("--quick", options->quick, "a smaller run, where the full one takes long");
  command->footer(std::string("Example:\n  thinbench experiment ") + name + " --out " + name +
                  ".json");
  command->callback([options, run, &out, &err] {
    const ExperimentReport report = run(options->quick);
    out << report.markdown;
    if (options->out.empty()) return;
    write_whole_file(options->out, report.json);
    err << "wrote " << options->out << '\n';
  });
}

}  // namespace

void add_experiment_command(CLI::App& program, std::ostream& out, std::ostream& err) {
  CLI::App* experiment =
      program.add_subcommand("experiment", "repeat what the paper says of its nets, as tables");
  experiment->require_subcommand(1);
  experiment->footer(
      "Examples:\n"
      "  thinbench experiment quantisation --out quantisation.json\n"
      "  thinbench experiment hidden-neurons --quick");
  const auto add = [&](const char* name, const char* what, const auto& run) {
    add_experiment(*experiment, name, what, out, err, run);
  };
  add("quantisation", "Table 1 in fixed point: how many bits keep it right",
      [](bool) { return quantisation_report(run_quantisation()); });
  add("hidden-neurons", "2 to 12 hidden neurons: how many are needed (under a minute)",
      [&err](bool quick) { return hidden_neurons(quick, err); });
  add("operation-counts", "operations a pixel, counted by running each method",
      [](bool) { return operation_counts_report(run_operation_counts()); });
  add("table-2", "the paper's times and their ratios",
      [](bool) { return table_2_report(then_and_now({})); });
}

}  // namespace thinbench
