// The variants of nets, and the default nets.
#pragma once

#include <memory>
#include <vector>

#include "nets/model.hpp"
#include "thinning/state.hpp"

namespace thinbench::detail {

/// The default net of a rule; nullptr for rules that are not nets. Two-layer nets use Table 1,
/// rounded to integers for net_two_layer_rounded; the cluster uses trained_cluster.hpp, as the
/// paper publishes no weights for it.
[[nodiscard]] std::shared_ptr<const NetModel> default_net(Rule rule);

/// The variants of a net. Techniques that need only its truth table (lut, bitpacked,
/// simd_bitpacked, simd_bitpacked_row) are the same for all nets; a net that has learned a thinning
/// rule runs that rule's circuit.
[[nodiscard]] std::vector<ThinningVariant> net_variants(Rule rule);

}  // namespace thinbench::detail
