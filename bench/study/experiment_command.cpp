// thinbench-study experiment: what the paper reports about its methods, measured again.
#include <filesystem>
#include <functional>
#include <memory>

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "experiments/experiments.hpp"
#include "experiments/thinning_quality.hpp"
#include "study/study.hpp"

namespace thinbench {
namespace {

struct ExperimentOptions {
  std::string out;
  bool quick = false;
  std::vector<std::string> images;
  BinariseOptions binarise;
  Options of_binarise;  // some were given
  std::string pictures;
};

/// The images by their files' names: directories are private.
std::string image_options(const ExperimentOptions& options) {
  std::string text;
  for (const std::string& image : options.images) {
    text += " --image " + std::filesystem::path(image).filename().string();
  }
  return text + given_words(options.of_binarise);
}

ExperimentReport run_edge_quality(const ExperimentOptions& options, const Console&) {
  return edge_quality(options.quick ? EdgeQualityChoice::quick() : EdgeQualityChoice{});
}

ExperimentReport run_hidden_neurons(const ExperimentOptions& options, const Console& console) {
  return hidden_neurons(
      options.quick ? HiddenNeuronsChoice::quick() : HiddenNeuronsChoice{},
      [&](double done) { console.err << fmt::format("hidden neurons: {:.0f} %\n", done * 100); });
}

ExperimentReport run_quality(const ExperimentOptions& options, const Console& console) {
  const std::vector<QualityInput> inputs =
      quality_inputs(options.images, options.binarise, &console.err);
  ExperimentReport report = thinning_quality(inputs, image_options(options));
  if (!options.pictures.empty()) write_skeletons(options.pictures, inputs);
  return report;
}

using Experiment = std::function<ExperimentReport(const ExperimentOptions&, const Console&)>;

int run(const ExperimentOptions& options, const Experiment& experiment, const Console& console) {
  check_targets({options.out});
  const ExperimentReport report = experiment(options, console);
  console.out << report.markdown;
  write_if_named(options.out, report.json, console.err);
  return kSuccess;
}

/// An experiment without options of its own.
Experiment plain(ExperimentReport (*experiment)()) {
  return [experiment](const ExperimentOptions&, const Console&) { return experiment(); };
}

struct AddedExperiment {
  Command command;
  std::shared_ptr<ExperimentOptions> options;

  const AddedExperiment& with_quick(const char* what) const {
    command.app->add_flag("--quick", options->quick, what);
    return *this;
  }
};

AddedExperiment add(CLI::App& parent, const std::string& name, const char* what,
                    const Experiment& experiment) {
  CLI::App* app = parent.add_subcommand(name, what);
  const auto options = std::make_shared<ExperimentOptions>();
  add_file_option(*app, "--out", options->out, "Write the data here, as JSON");
  const std::string call = "\n  thinbench-study experiment " + name;
  app->footer("Examples:" + call + call + " --out " + name + ".json");
  const auto work = [options, experiment](const Console& console) {
    return run(*options, experiment, console);
  };
  return {{app, work}, options};
}

AddedExperiment add_quality(CLI::App& parent) {
  AddedExperiment added =
      add(parent, "quality", "Skeletons of every thinning operation: topology, place, symmetry",
          &run_quality);
  CLI::Option* image =
      added.command.app
          ->add_option("--image", added.options->images, "Image to thin as well (repeatable)")
          ->type_name("FILE")
          ->allow_extra_args(false);
  added.options->of_binarise =
      add_binarise_options(*added.command.app, added.options->binarise, image);
  add_value(*added.command.app, "--pictures-out", added.options->pictures,
            "Write the skeletons to this directory", not_empty(), "DIR");
  return added;
}

}  // namespace

Command add_experiment_command(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("experiment", "Repeat what the paper says of its methods, as tables");
  app->require_subcommand(1);
  app->footer(R"(Examples:
  thinbench-study experiment quantisation --out quantisation.json
  thinbench-study experiment hidden-neurons --quick
  thinbench-study experiment quality --image parts.jpg --foreground dark)");
  const std::vector<AddedExperiment> added = {
      add(*app, "edge-quality", "Each edge operator against the scene's true contours, with noise",
          &run_edge_quality)
          .with_quick("Less noise, one seed"),
      add(*app, "literal-holes", "On which images the published relabelling scan counts right",
          plain(&literal_holes)),
      add(*app, "cluster-runs", "How many single-layer nets the rule needs", plain(&cluster_runs)),
      add(*app, "quantisation", "Table 1 in fixed point: how many bits keep it right",
          plain(&quantisation)),
      add(*app, "hidden-neurons", "2 to 12 hidden neurons: how many are needed (under a minute)",
          &run_hidden_neurons)
          .with_quick("Fewer and shorter trainings"),
      add_quality(*app),
      add(*app, "operation-counts", "Operations per pixel, counted by running each method",
          plain(&operation_counts))};
  Command command = {app, {}, {}};
  for (const AddedExperiment& one : added) command.parts.push_back(one.command);
  return command;
}

}  // namespace thinbench
