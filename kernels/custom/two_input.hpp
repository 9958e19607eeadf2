// Circuits in steps of two inputs, for processors without vpternlog.
#pragma once

#include <cstdint>
#include <vector>

#include "custom/gate_network.hpp"

namespace thinbench::detail {

enum class Operation : std::uint8_t { conjunction, disjunction, difference, exclusive };

/// The value `left op right`; the difference is ~left & right. Operands are numbers of values: 0 to
/// 8 are the pixels of the window, 9 + i is the result of step i.
struct Step {
  Operation operation;
  std::uint16_t left;
  std::uint16_t right;

  friend auto operator<=>(const Step&, const Step&) = default;
};

/// `inverted`: the result is the complement of value `output`.
struct StepNetwork {
  std::vector<Step> steps;
  int output = 0;
  bool inverted = false;
};

/// The least number of steps for a gate that shares none with others. Complements are free.
[[nodiscard]] std::uint8_t two_input_steps(std::uint8_t function);

/// The network in steps. Equal steps are shared.
[[nodiscard]] StepNetwork two_input_network(const GateNetwork& network);

}  // namespace thinbench::detail
