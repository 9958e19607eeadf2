#include <nlohmann/json.hpp>

#include "experiments/operation_counts.hpp"
#include "support/text.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::ordered_json;
using Cells = std::vector<std::vector<std::string>>;

Json operations_json(const Operations& operations) {
  return {{"logical", operations.logical},
          {"additions", operations.additions},
          {"multiplications", operations.multiplications},
          {"divisions", operations.divisions},
          {"powers", operations.powers},
          {"comparisons", operations.comparisons},
          {"arithmetic", operations.arithmetic()}};
}

Json gates_json(const Gates& gates) {
  return {{"gates", gates.gates}, {"inverters", gates.inverters}};
}

Json counts_json(const OperationCounts& counts) {
  Json json = {{"per", "foreground pixel; each kind's largest count over the 256 neighbourhoods"},
               {"methods", Json::array()},
               {"circuit",
                {{"two_input", gates_json(counts.circuit.two_input)},
                 {"three_input", gates_json(counts.circuit.three_input)}}},
               {"nets", Json::array()}};
  for (const OperationCount& method : counts.methods) {
    json["methods"].push_back({{"method", method.method},
                               {"paper", method.paper},
                               {"sums", operations_json(method.most.sums)},
                               {"activations", operations_json(method.most.activations)}});
  }
  for (const CompiledNet& net : counts.nets) {
    json["nets"].push_back({{"net", net.net}, {"compiles_to_the_rule", net.same_table}});
  }
  return json;
}

std::string methods_markdown(const std::vector<OperationCount>& methods) {
  Cells cells;
  for (const OperationCount& method : methods) {
    const Operations& sums = method.most.sums;
    const Operations& activations = method.most.activations;
    cells.push_back({method.method, std::to_string(sums.logical), std::to_string(sums.additions),
                     std::to_string(sums.multiplications), std::to_string(sums.powers),
                     std::to_string(sums.comparisons), std::to_string(activations.arithmetic()),
                     std::to_string(activations.comparisons),
                     std::to_string(sums.arithmetic() + activations.arithmetic()), method.paper});
  }
  return markdown_table(
      {"Method", "Logical", "Additions", "Multiplications", "Powers", "Comparisons",
       "Arithmetic of activations", "Comparisons of activations", "Arithmetic in all", "Paper"},
      cells);
}

std::string circuit_markdown(const CircuitCount& circuit) {
  const auto row = [](const char* kind, const Gates& gates) {
    return std::vector<std::string>{kind, std::to_string(gates.gates),
                                    std::to_string(gates.inverters)};
  };
  return markdown_table({"Circuit", "Gates", "Inverters"},
                        {row("Two inputs per gate", circuit.two_input),
                         row("Three inputs per gate", circuit.three_input)});
}

std::string nets_markdown(const std::vector<CompiledNet>& nets) {
  Cells cells;
  for (const CompiledNet& net : nets) cells.push_back({net.net, net.same_table ? "yes" : "no"});
  return markdown_table({"Net", "Same table as the rule"}, cells);
}

}  // namespace

ExperimentReport operation_counts_report(const OperationCounts& counts) {
  return {experiment_json("operation-counts", counts_json(counts)),
          "Operations per foreground pixel, counted by running each method; at most, over the 256 "
          "neighbourhoods:\n\n" +
              methods_markdown(counts.methods) +
              "\nThe rule as a circuit, the AND with the pixel included. One evaluation serves all "
              "pixels of a word:\n\n" +
              circuit_markdown(counts.circuit) +
              "\nA net with the rule's table compiles to the rule's circuit:\n\n" +
              nets_markdown(counts.nets)};
}

}  // namespace thinbench
