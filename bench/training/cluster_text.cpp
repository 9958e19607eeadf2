#include "training/cluster_text.hpp"

#include "support/text.hpp"
#include "training/keep_table.hpp"

namespace thinbench {
namespace {

std::string times_and_descriptor(const WeightedDescriptor& term) {
  std::string text = std::to_string(term.descriptor);
  return term.times == 1 ? text : std::to_string(term.times) + "×" + text;
}

/// "5 + 52 + 65 = 17 + 37 + 68": as vectors, the removed ones add up to the kept ones.
std::string equation(const Contradiction& contradiction, const KeepTable& table) {
  std::vector<std::string> removed;
  std::vector<std::string> kept;
  for (const WeightedDescriptor& term : contradiction) {
    (keeps(table, term.descriptor) ? kept : removed).push_back(times_and_descriptor(term));
  }
  return joined(removed, " + ") + " = " + joined(kept, " + ");
}

/// A float literal of C++: 7.18F, -1.0F, 1e+20F.
std::string literal(float value) {
  const std::string text = shortest(value);
  const bool whole = text.find_first_of(".e") == std::string::npos;
  return text + (whole ? ".0F" : "F");
}

std::string net_initialiser(const ClusterNet& net) {
  std::vector<std::string> weights;
  for (const float weight : net.neuron.weight) weights.push_back(literal(weight));
  return std::string("{") + std::to_string(net.last) + ", {{" + joined(weights, ", ") + "}, " +
         literal(net.neuron.bias) + "}}";
}

}  // namespace

std::string cluster_markdown(const std::vector<TrainedRun>& runs) {
  const KeepTable table = keep_table_of_rule();
  std::vector<std::vector<std::string>> rows;
  for (const TrainedRun& trained : runs) {
    std::vector<std::string> row = {std::to_string(trained.run.first) + "-" +
                                    std::to_string(trained.run.last)};
    for (const std::int32_t weight : trained.neuron.weight) row.push_back(std::to_string(weight));
    row.push_back(std::to_string(trained.neuron.bias));
    row.push_back(std::to_string(trained.epochs));
    row.push_back(trained.one_more.empty() ? "" : equation(trained.one_more, table));
    rows.push_back(row);
  }
  return markdown_table({"Descriptors", "W0", "W1", "W2", "W3", "W4", "W5", "W6", "W7", "B",
                         "Epochs", "One more is impossible: removed = kept"},
                        rows);
}

std::string cluster_header(const ClusterWeights& weights, const std::string& command) {
  std::vector<std::string> nets;
  nets.reserve(kMaxClusterNets);
  for (int n = 0; n < weights.count; ++n) nets.push_back(net_initialiser(weights.nets[n]));
  return "// Weights of a cluster of single-layer nets (section 3.3), correct on all 256 "
         "descriptors "
         "of the\n// modified Naccache-Shinghal rule, with the minimum number of nets. Generated "
         "by\n//     " +
         command +
         "\n#pragma once\n\n#include \"thinbench/nets.hpp\"\n\nnamespace thinbench::detail {\n\n"
         "inline constexpr ClusterWeights kTrainedCluster = {\n    " +
         std::to_string(weights.count) + ",\n    {" + joined(nets, ",\n     ") +
         "}};\n\n}  // namespace thinbench::detail\n";
}

}  // namespace thinbench
