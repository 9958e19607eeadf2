// Any rule of the eight neighbours as a sequence of multiplexers.
#pragma once

#include "nets/model.hpp"

namespace thinbench::detail {

/// The reduced ordered decision diagram of `stays[descriptor]`, 256 entries of 0 and 1. The order
/// of variables is improved by swaps until none saves a node.
[[nodiscard]] MuxProgram make_decision_diagram(const std::uint8_t* stays);

}  // namespace thinbench::detail
