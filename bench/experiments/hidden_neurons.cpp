#include "experiments/hidden_neurons.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "support/text.hpp"
#include "training/two_layer_training.hpp"

namespace thinbench {
namespace {

double median(std::vector<int> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 != 0 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

HiddenNeuronsRow measure(int hidden, const HiddenNeuronsChoice& choice) {
  std::vector<int> right;
  std::vector<int> epochs;
  for (int seed = 1; seed <= choice.seeds; ++seed) {
    const TrainedTwoLayer trained =
        train_two_layer(keep_table_of_rule(), {.seed = static_cast<std::uint64_t>(seed),
                                               .hidden = hidden,
                                               .max_restarts = 0,
                                               .max_epochs = choice.max_epochs,
                                               .also_linear = false});
    right.push_back(trained.right_sigmoid);
    if (trained.right_sigmoid == kDescriptors) epochs.push_back(trained.epochs);
  }
  return {hidden,
          choice.seeds,
          *std::max_element(right.begin(), right.end()),
          median(right),
          static_cast<int>(epochs.size()),
          median(epochs)};
}

}  // namespace

std::vector<HiddenNeuronsRow> run_hidden_neurons(const HiddenNeuronsChoice& choice,
                                                 const ProgressReport& progress) {
  std::vector<HiddenNeuronsRow> rows;
  for (int hidden = choice.fewest; hidden <= choice.most; ++hidden) {
    progress(static_cast<double>(rows.size()) / (choice.most - choice.fewest + 1));
    rows.push_back(measure(hidden, choice));
  }
  return rows;
}

int fewest_hidden_neurons(const std::vector<HiddenNeuronsRow>& rows) {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [](const HiddenNeuronsRow& row) { return row.perfect > 0; });
  return found == rows.end() ? 0 : found->hidden;
}

ExperimentReport hidden_neurons_report(const std::vector<HiddenNeuronsRow>& rows,
                                       const HiddenNeuronsChoice& choice) {
  nlohmann::ordered_json json = {{"descriptors", kDescriptors},
                                 {"seeds", choice.seeds},
                                 {"max_epochs", choice.max_epochs},
                                 {"fewest_that_reached_all", fewest_hidden_neurons(rows)},
                                 {"rows", nlohmann::ordered_json::array()}};
  std::vector<std::vector<std::string>> cells;
  for (const HiddenNeuronsRow& row : rows) {
    json["rows"].push_back({{"hidden", row.hidden},
                            {"best", row.best},
                            {"median", row.median},
                            {"seeds_with_all_right", row.perfect},
                            {"median_epochs_of_those", row.epochs}});
    cells.push_back({std::to_string(row.hidden), std::to_string(row.best), fixed(row.median, 1),
                     std::to_string(row.perfect) + " of " + std::to_string(row.seeds),
                     row.perfect == 0 ? "" : fixed(row.epochs, 0)});
  }
  return {experiment_json("hidden-neurons", json, choice.options),
          "Descriptors of 256 that nets learned with the sigmoid, from " +
              std::to_string(choice.seeds) + " random starts of at most " +
              std::to_string(choice.max_epochs) + " epochs:\n\n" +
              markdown_table({"Hidden neurons", "Best", "Median", "Starts that reached 256",
                              "Median epochs of those"},
                             cells)};
}

}  // namespace thinbench
