// "Integer approximation of weights and biases ... reduces recognition rate" (section 5): by how
// much, and how many fractional bits bring it back.
#pragma once

#include <vector>

#include "experiments/report.hpp"
#include "training/two_layer_net.hpp"

namespace thinbench {

enum class Quantisation {
  round,     // to the nearest multiple of 2^-bits, halves away from zero
  truncate,  // towards zero
};

struct QuantisationRow {
  Quantisation way;
  int fractional_bits;
  int right_sigmoid;  // descriptors of 256
  int right_linear;
  int largest_integer;  // magnitude of the largest weight or bias, times 2^fractional_bits
};

/// All weights and biases as multiples of 2^-bits.
[[nodiscard]] HiddenLayerNet quantised(const HiddenLayerNet& net, Quantisation way, int bits);

/// Table 1 with 0 to 8 fractional bits, rounded, then truncated.
[[nodiscard]] std::vector<QuantisationRow> run_quantisation();

[[nodiscard]] ExperimentReport quantisation_report(const std::vector<QuantisationRow>& rows);

}  // namespace thinbench
