#include "experiments/cluster_runs.hpp"

#include <algorithm>
#include <cstdlib>

#include <nlohmann/json.hpp>

#include "support/text.hpp"

namespace thinbench {
namespace {

int largest_weight(const IntegerNeuron& neuron) {
  int largest = std::abs(neuron.bias);
  for (const std::int32_t weight : neuron.weight) largest = std::max(largest, std::abs(weight));
  return largest;
}

}  // namespace

std::vector<TrainedRun> run_cluster_runs() {
  return train_cluster(keep_table_of_rule(), {kMaxClusterNets, /*small_integers=*/true});
}

ExperimentReport cluster_runs_report(const std::vector<TrainedRun>& runs) {
  nlohmann::ordered_json json = {{"descriptors", kDescriptors},
                                 {"nets", runs.size()},
                                 {"rows", nlohmann::ordered_json::array()}};
  std::vector<std::vector<std::string>> cells;
  for (const TrainedRun& trained : runs) {
    const int largest = largest_weight(trained.neuron);
    json["rows"].push_back({{"first", trained.run.first},
                            {"last", trained.run.last},
                            {"epochs", trained.epochs},
                            {"largest_weight", largest}});
    cells.push_back({std::to_string(trained.run.first), std::to_string(trained.run.last),
                     std::to_string(trained.epochs), std::to_string(largest)});
  }
  return {experiment_json("cluster-runs", json),
          "Runs of descriptors that one neuron each can learn, none longer possible: " +
              std::to_string(runs.size()) + " nets, and no cut has fewer.\n\n" +
              markdown_table({"First", "Last", "Epochs", "Largest weight"}, cells)};
}

}  // namespace thinbench
