// "A clue indicating the speed is the number of operations" (section 4): counted per foreground
// pixel by running each method on counting types, and again after compilation to a circuit.
#pragma once

#include <string>
#include <vector>

#include "experiments/counting.hpp"
#include "experiments/report.hpp"

namespace thinbench {

struct OperationCount {
  std::string method;
  std::string paper;  // what section 4 says; empty where it says nothing
  Tally most;         // each kind's largest count over the 256 neighbourhoods
};

struct CircuitCount {
  Gates two_input;
  Gates three_input;
};

/// A net, and whether its table is the rule's: then it compiles to the rule's circuit.
struct CompiledNet {
  std::string net;
  bool same_table;
};

struct OperationCounts {
  std::vector<OperationCount> methods;
  CircuitCount circuit;  // of the rule, the AND with p included
  std::vector<CompiledNet> nets;
};

[[nodiscard]] OperationCounts run_operation_counts();

[[nodiscard]] ExperimentReport operation_counts_report(const OperationCounts& counts);

}  // namespace thinbench
