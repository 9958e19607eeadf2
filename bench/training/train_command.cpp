#include "training/train_command.hpp"

#include <memory>
#include <stdexcept>

#include <CLI/CLI.hpp>

#include "training/cluster_text.hpp"
#include "training/text.hpp"
#include "training/two_layer_training.hpp"
#include "training/weights_file.hpp"

namespace thinbench {
namespace {

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

void write_if_named(const std::string& path, const std::string& text, std::ostream& err) {
  if (path.empty()) return;
  write_whole_file(path, text);
  err << "wrote " << path << '\n';
}

std::string summary(const TrainedTwoLayer& trained) {
  return "Right on " + std::to_string(trained.right_sigmoid) +
         " of 256 descriptors with the sigmoid and " + std::to_string(trained.right_linear) +
         " with the linear threshold, after " + std::to_string(trained.epochs) + " epochs and " +
         std::to_string(trained.restarts) + " restarts (" + std::to_string(trained.total_epochs) +
         " epochs in all).\n";
}

void run_two_layer(const TwoLayerOptions& options, std::ostream& out, std::ostream& err) {
  const bool is_8_8_1 = options.training.hidden == kHiddenNeurons;
  if (!options.out.empty() && !is_8_8_1) {
    throw std::invalid_argument("--out: weights files hold nets of 8 hidden neurons, not " +
                                std::to_string(options.training.hidden));
  }
  const TrainedTwoLayer trained = train_two_layer(stay_table_of_rule(), options.training);
  if (trained.right_sigmoid != kDescriptors) {
    throw std::runtime_error("training reached " + std::to_string(trained.right_sigmoid) +
                             " of 256 descriptors in " + std::to_string(trained.total_epochs) +
                             " epochs; try another --seed or more --max-restarts");
  }
  const std::string table = table_markdown(trained.net);
  out << summary(trained) << '\n' << table;
  const std::string command =
      "thinbench train two-layer --seed " + std::to_string(options.training.seed);
  write_if_named(options.markdown, table, err);
  if (is_8_8_1) write_if_named(options.out, weights_json(to_weights(trained.net), command), err);
}

void run_cluster(const ClusterOptions& options, std::ostream& out, std::ostream& err) {
  const std::vector<TrainedRun> runs = train_cluster(stay_table_of_rule(), options.training);
  const ClusterWeights weights = cluster_weights(runs);
  const std::string command = std::string("thinbench train cluster") +
                              (options.training.small_integers ? " --integer" : "");
  out << runs.size() << " nets, right on all 256 descriptors; no fewer can be.\n\n"
      << cluster_markdown(runs);
  write_if_named(options.out, weights_json(weights, command), err);
  write_if_named(options.header, cluster_header(weights, command + " --header " + options.header),
                 err);
}

void add_two_layer(CLI::App& train, std::ostream& out, std::ostream& err) {
  auto options = std::make_shared<TwoLayerOptions>();
  TwoLayerTraining& training = options->training;
  CLI::App* command = train.add_subcommand(
      "two-layer", "back-propagation with the sigmoid until all 256 descriptors are right");
  command->add_option("--seed", training.seed, "of the first weights")->capture_default_str();
  command->add_option("--hidden", training.hidden, "hidden neurons")
      ->capture_default_str()
      ->check(CLI::Range(1, 64));
  command->add_option("--max-restarts", training.max_restarts, "with fresh weights")
      ->capture_default_str()
      ->check(CLI::Range(0, 10000));
  command->add_option("--out", options->out, "write the weights here, as JSON");
  command->add_option("--markdown", options->markdown, "write the table here");
  command->footer(
      "Weights are rounded to hundredths, as in Table 1 of the paper, before they are judged.\n"
      "Examples:\n"
      "  thinbench train two-layer --seed 2 --out weights.json\n"
      "  thinbench train two-layer --hidden 5 --max-restarts 100");
  command->callback([options, &out, &err] { run_two_layer(*options, out, err); });
}

void add_cluster(CLI::App& train, std::ostream& out, std::ostream& err) {
  auto options = std::make_shared<ClusterOptions>();
  CLI::App* command = train.add_subcommand(
      "cluster", "single-layer nets for the longest runs of descriptors that one neuron can learn");
  command->add_option("--max-nets", options->training.max_nets, "fail if it takes more")
      ->capture_default_str()
      ->check(CLI::Range(1, kMostClusterNets));
  command->add_flag("--integer", options->training.small_integers,
                    "make the weights small whole numbers");
  command->add_option("--out", options->out, "write the weights here, as JSON");
  command->add_option("--header", options->header, "write the weights here, as a C++ header");
  command->footer(
      "The perceptron rule adds and subtracts vectors of 0 and 1, so weights are whole numbers in\n"
      "either case; --integer goes on to shrink them.\n"
      "Examples:\n"
      "  thinbench train cluster --out cluster.json\n"
      "  thinbench train cluster --integer --header kernels/nets/trained_cluster.hpp");
  command->callback([options, &out, &err] { run_cluster(*options, out, err); });
}

}  // namespace

void add_train_command(CLI::App& program, std::ostream& out, std::ostream& err) {
  CLI::App* train = program.add_subcommand("train", "teach the nets of the paper the rule");
  train->require_subcommand(1);
  train->footer(
      "Examples:\n"
      "  thinbench train two-layer --seed 2 --out weights.json\n"
      "  thinbench train cluster --integer");
  add_two_layer(*train, out, err);
  add_cluster(*train, out, err);
}

}  // namespace thinbench
