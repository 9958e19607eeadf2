// Circuits of gates with two inputs, for processors without vpternlog.
#pragma once

#include <cstdint>

#include "compile/gate_network.hpp"

namespace thinbench::detail {

/// The least number of steps for a gate that shares none with others. Complements are free.
[[nodiscard]] std::uint8_t two_input_steps(std::uint8_t function);

/// The network in kAnd, kOr, kXor, kAndNot and kNot. Equal steps are shared.
[[nodiscard]] GateNetwork in_two_input_gates(const GateNetwork& network);

}  // namespace thinbench::detail
