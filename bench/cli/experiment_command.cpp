// thinbench experiment: what the paper says of its methods, measured again.
#include <filesystem>
#include <memory>

#include "cli/arguments.hpp"
#include "cli/binarise_options.hpp"
#include "cli/command.hpp"
#include "experiments/batches.hpp"
#include "experiments/cluster_runs.hpp"
#include "experiments/edge_quality.hpp"
#include "experiments/hidden_neurons.hpp"
#include "experiments/literal_holes.hpp"
#include "experiments/operation_counts.hpp"
#include "experiments/quantisation.hpp"
#include "experiments/table_2.hpp"
#include "experiments/thinning_quality.hpp"
#include "support/text.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

constexpr const char* kExamples = R"(Examples:
  thinbench experiment quantisation --out quantisation.json
  thinbench experiment hidden-neurons --quick
  thinbench experiment quality --image parts.jpg --foreground dark
  thinbench experiment table-2 --results results/my-machine/2026-11-21-abc)";

struct ExperimentOptions {
  std::string out;
  std::string results;
  bool quick = false;
  std::vector<std::string> images;
  BinariseOptions binarise;
  std::string pictures;
};

/// The images by their files' names: directories are private.
std::string image_options(const ExperimentOptions& options) {
  std::string text;
  for (const std::string& image : options.images) {
    text += " --image " + std::filesystem::path(image).filename().string();
  }
  return text + binarise_words(options.binarise);
}

ExperimentReport edge_quality(const ExperimentOptions& options, const Console&) {
  const EdgeQualityChoice choice = options.quick ? EdgeQualityChoice::quick() : EdgeQualityChoice{};
  return edge_quality_report(run_edge_quality(choice), choice, options.quick ? " --quick" : "");
}

ExperimentReport literal_holes(const ExperimentOptions&, const Console&) {
  return literal_holes_report(run_literal_holes());
}

ExperimentReport batches(const ExperimentOptions& options, const Console&) {
  const BatchesChoice choice = options.quick ? BatchesChoice::quick() : BatchesChoice{};
  return batches_report(run_batches(choice), choice, options.quick ? " --quick" : "");
}

ExperimentReport cluster_runs(const ExperimentOptions&, const Console&) {
  return cluster_runs_report(run_cluster_runs());
}

ExperimentReport quantisation(const ExperimentOptions&, const Console&) {
  return quantisation_report(run_quantisation());
}

ExperimentReport hidden_neurons(const ExperimentOptions& options, const Console& console) {
  const auto choice = options.quick ? HiddenNeuronsChoice::quick() : HiddenNeuronsChoice{};
  const auto progress = [&](double done) {
    console.err << "hidden neurons: " << fixed(done * 100, 0) << " %\n" << std::flush;
  };
  return hidden_neurons_report(run_hidden_neurons(choice, progress), choice);
}

ExperimentReport operation_counts(const ExperimentOptions&, const Console&) {
  return operation_counts_report(run_operation_counts());
}

ExperimentReport table_2(const ExperimentOptions& options, const Console&) {
  if (options.results.empty()) return table_2_report(then_and_now({}));
  return table_2_report(then_and_now(read_measured_times(options.results)),
                        " --results " + options.results);
}

ExperimentReport quality(const ExperimentOptions& options, const Console& console) {
  const std::vector<QualityInput> inputs =
      quality_inputs(options.images, options.binarise, &console.err);
  ExperimentReport report =
      thinning_quality_report(run_thinning_quality(inputs), image_options(options));
  if (!options.pictures.empty()) write_skeletons(options.pictures, inputs);
  return report;
}

using Experiment = ExperimentReport (*)(const ExperimentOptions&, const Console&);

int run(const ExperimentOptions& options, Experiment experiment, const Console& console) {
  if (!options.out.empty()) check_target(options.out);
  const ExperimentReport report = experiment(options, console);
  console.out << report.markdown;
  if (options.out.empty()) return kSuccess;
  write_whole_file(options.out, report.json);
  console.err << "wrote " << options.out << '\n';
  return kSuccess;
}

struct AddedExperiment {
  Command command;
  std::shared_ptr<ExperimentOptions> options;
};

AddedExperiment add(CLI::App& parent, const std::string& name, const char* what,
                    Experiment experiment) {
  CLI::App* app = parent.add_subcommand(name, what);
  const auto options = std::make_shared<ExperimentOptions>();
  app->add_option("--out", options->out, "Write the data here, as JSON")
      ->check(not_empty())
      ->type_name("FILE");
  const std::string call = "\n  thinbench experiment " + name;
  app->footer("Examples:" + call + call + " --out " + name + ".json");
  const auto work = [options, experiment](const Console& console) {
    return run(*options, experiment, console);
  };
  return {{app, work}, options};
}

AddedExperiment add_quality(CLI::App& parent) {
  AddedExperiment added =
      add(parent, "quality", "Skeletons of every thinning operation: topology, place, symmetry",
          &quality);
  CLI::Option* image =
      added.command.app
          ->add_option("--image", added.options->images, "Image to thin as well (repeatable)")
          ->type_name("FILE")
          ->allow_extra_args(false);
  add_binarise_options(*added.command.app, added.options->binarise, image);
  added.command.app
      ->add_option("--pictures-out", added.options->pictures,
                   "Write the skeletons to this directory")
      ->check(not_empty())
      ->type_name("DIR");
  return added;
}

}  // namespace

Command add_experiment_command(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("experiment", "Repeat what the paper says of its methods, as tables");
  app->require_subcommand(1);
  app->footer(kExamples);
  const AddedExperiment edges =
      add(*app, "edge-quality", "Each edge operator against the scene's true contours, with noise",
          &edge_quality);
  edges.command.app->add_flag("--quick", edges.options->quick, "Less noise, one seed");
  const AddedExperiment literal =
      add(*app, "literal-holes", "On which pictures the printed relabelling scan counts right",
          &literal_holes);
  const AddedExperiment cluster =
      add(*app, "cluster-runs", "How many single-layer nets the rule needs", &cluster_runs);
  const AddedExperiment fixed_point = add(
      *app, "quantisation", "Table 1 in fixed point: how many bits keep it right", &quantisation);
  const AddedExperiment hidden =
      add(*app, "hidden-neurons", "2 to 12 hidden neurons: how many are needed (under a minute)",
          &hidden_neurons);
  hidden.command.app->add_flag("--quick", hidden.options->quick, "Fewer and shorter trainings");
  const AddedExperiment skeletons = add_quality(*app);
  const AddedExperiment counts =
      add(*app, "operation-counts", "Operations a pixel, counted by running each method",
          &operation_counts);
  const AddedExperiment times =
      add(*app, "table-2", "The paper's times and their ratios", &table_2);
  times.command.app
      ->add_option("--results", times.options->results,
                   "Results directory of a study, whose times are set beside the paper's")
      ->check(not_empty())
      ->type_name("DIR");
  const AddedExperiment many =
      add(*app, "batches", "Many small images at once against one by one", &batches);
  many.command.app->add_flag("--quick", many.options->quick, "Fewer images and turns");
  return {app,
          {},
          {edges.command, literal.command, cluster.command, fixed_point.command, hidden.command,
           skeletons.command, counts.command, times.command, many.command}};
}

}  // namespace thinbench
