// thinbench-study train: teaches the nets of the paper the rule.
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "study/study.hpp"
#include "training/cluster.hpp"
#include "training/two_layer.hpp"
#include "training/weights_text.hpp"

namespace thinbench {
namespace {

constexpr const char* kTwoLayerExamples =
    R"(Weights are rounded to hundredths, as in Table 1 of the paper, before they are judged.

Examples:
  thinbench-study train two-layer --seed 2 --out weights.json
  thinbench-study train two-layer --hidden 5 --max-restarts 100)";

constexpr const char* kClusterExamples =
    R"(The perceptron rule adds and subtracts vectors of 0 and 1, so weights are integers in
either case; --integer goes on to shrink them.

Examples:
  thinbench-study train cluster --out cluster.json
  thinbench-study train cluster --integer --header kernels/rules/trained_cluster.hpp)";

constexpr std::uint64_t kMaxHidden = 64;
constexpr std::uint64_t kMaxRestarts = 10000;

struct TwoLayerOptions {
  TwoLayerTraining training;
  std::string out;
  std::string markdown;
};

struct ClusterOptions {
  ClusterTraining training;
  std::string out;
  std::string header;
};

std::string summary(const TrainedTwoLayer& trained) {
  return fmt::format(
      "Correct on {} of 256 descriptors with the sigmoid and {} with the linear threshold, after "
      "{} "
      "epochs and {} restarts ({} epochs in all).\n",
      trained.right_sigmoid, trained.right_linear, trained.epochs, trained.restarts,
      trained.total_epochs);
}

int run_two_layer(const TwoLayerOptions& options, const Console& console) {
  const bool is_8_8_1 = options.training.hidden == kHiddenNeurons;
  if (!options.out.empty() && !is_8_8_1) {
    throw UsageError(fmt::format("--out: weights files hold nets of 8 hidden neurons, not {}",
                                 options.training.hidden));
  }
  check_targets({options.out, options.markdown});
  const TrainedTwoLayer trained = train_two_layer(keep_table_of_rule(), options.training);
  if (trained.right_sigmoid != kDescriptors) {
    throw std::runtime_error(fmt::format(
        "training reached {} of 256 descriptors in {} epochs; try another --seed or more "
        "--max-restarts",
        trained.right_sigmoid, trained.total_epochs));
  }
  const std::string table = table_markdown(trained.net);
  console.out << summary(trained) << '\n' << table;
  const std::string command =
      "thinbench-study train two-layer --seed " + std::to_string(options.training.seed);
  write_if_named(options.markdown, table, console.err);
  if (is_8_8_1) {
    write_if_named(options.out, weights_json(to_weights(trained.net), command), console.err);
  }
  return kSuccess;
}

int run_cluster(const ClusterOptions& options, const Console& console) {
  check_targets({options.out, options.header});
  const std::vector<TrainedRun> runs = train_cluster(keep_table_of_rule(), options.training);
  const ClusterWeights weights = cluster_weights(runs);
  const std::string command = std::string("thinbench-study train cluster") +
                              (options.training.small_integers ? " --integer" : "");
  console.out << runs.size() << " nets, correct on all 256 descriptors; no division has fewer.\n\n"
              << cluster_markdown(runs);
  write_if_named(options.out, weights_json(weights, command), console.err);
  write_if_named(options.header, cluster_header(weights, command + " --header " + options.header),
                 console.err);
  return kSuccess;
}

Command add_two_layer(CLI::App& train) {
  CLI::App* app = train.add_subcommand(
      "two-layer", "Back-propagation with the sigmoid until all 256 descriptors are right");
  const auto options = std::make_shared<TwoLayerOptions>();
  add_value(*app, "--seed", options->training.seed, "Picks the first weights, 0 to 2^64 - 1",
            whole_number(0, UINT64_MAX), "N")
      ->capture_default_str();
  add_value(*app, "--hidden", options->training.hidden, "Hidden neurons, 1 to 64",
            whole_number(1, kMaxHidden), "N")
      ->capture_default_str();
  add_value(*app, "--max-restarts", options->training.max_restarts,
            "Starts with fresh weights, 0 to 10000", whole_number(0, kMaxRestarts), "N")
      ->capture_default_str();
  add_file_option(*app, "--out", options->out, "Write the weights here, as JSON");
  add_file_option(*app, "--markdown", options->markdown, "Write the table here");
  app->footer(kTwoLayerExamples);
  return {app, [options](const Console& console) { return run_two_layer(*options, console); }};
}

Command add_cluster(CLI::App& train) {
  CLI::App* app = train.add_subcommand(
      "cluster", "Single-layer nets for the longest runs of descriptors that one neuron can learn");
  const auto options = std::make_shared<ClusterOptions>();
  add_value(*app, "--max-nets", options->training.max_nets, "Fail if it takes more, 1 to 16",
            whole_number(1, kMaxClusterNets), "N")
      ->capture_default_str();
  app->add_flag("--integer", options->training.small_integers, "Make the weights small integers");
  add_file_option(*app, "--out", options->out, "Write the weights here, as JSON");
  add_file_option(*app, "--header", options->header, "Write the weights here, as a C++ header");
  app->footer(kClusterExamples);
  return {app, [options](const Console& console) { return run_cluster(*options, console); }};
}

}  // namespace

Command add_train_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("train", "Teach the nets of the paper the rule");
  app->require_subcommand(1);
  app->footer(R"(Examples:
  thinbench-study train two-layer --seed 2 --out weights.json
  thinbench-study train cluster --integer)");
  return {app, {}, {add_two_layer(*app), add_cluster(*app)}};
}

}  // namespace thinbench
