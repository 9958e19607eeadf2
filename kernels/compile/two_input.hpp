// Circuits in steps of two inputs, for processors without vpternlog.
#pragma once

#include <cstdint>

#include "compile/gate_network.hpp"
#include "compile/program.hpp"

namespace thinbench::detail {

/// The least number of steps for a gate that shares none with others. Complements are free.
[[nodiscard]] std::uint8_t two_input_steps(std::uint8_t function);

/// The network in two-input steps. Equal steps are shared.
[[nodiscard]] Program two_input_program(const GateNetwork& network);

}  // namespace thinbench::detail
