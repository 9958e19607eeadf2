// Circuits of gates with up to three inputs, as vpternlog computes them, for functions of the 3 x 3
// window.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "thinbench/rule.hpp"

namespace thinbench::detail {

inline constexpr int kWindowPixels = 9;
/// Also the limit of what `inputs` can number.
inline constexpr int kMaxGates = 240;

/// A gate with inputs a, b, c. Bit 4a + 2b + c of `function` is its value. An input is the number
/// of a value: 0 to 8 are the pixels of the window, 9 + i is the result of gate i.
struct Gate {
  std::uint8_t function;
  std::array<std::uint8_t, 3> inputs;
};

/// Gates read earlier gates only. `output` is the number of a value.
struct GateNetwork {
  std::vector<Gate> gates;
  int output = 0;
};

/// The values of a gate on all 512 windows.
[[nodiscard]] WindowTable gate_table(std::uint8_t function, const WindowTable& a,
                                     const WindowTable& b, const WindowTable& c);

/// The values of pixel `pixel` on all windows.
[[nodiscard]] const WindowTable& pixel_table(int pixel);

/// The tables of all values: pixels, then gates.
[[nodiscard]] std::vector<WindowTable> tables_of(const GateNetwork& network);

/// The function of a gate whose input `input` (0 to 2) is inverted.
[[nodiscard]] constexpr std::uint8_t with_inverted_input(std::uint8_t function, int input) {
  constexpr std::uint8_t where_set[] = {0xF0, 0xCC, 0xAA};
  const std::uint8_t mask = where_set[input];
  const int shift = 4 >> input;
  return static_cast<std::uint8_t>((function & mask) >> shift | (function << shift & mask));
}

/// What each of the 256 gates costs.
using GateCosts = std::array<std::uint8_t, 256>;

/// 1 for each gate: what processors with a three-input instruction pay.
[[nodiscard]] const GateCosts& ternary_costs();

/// The number of two-input operations (and, or, xor, and-not) of a gate.
[[nodiscard]] const GateCosts& two_input_costs();

/// For a gate of pixels of one row: its value for the west, centre and east pixel, as a truth table
/// with these as inputs a, b, c; else -1. Engines compute equal functions of different rows once
/// per row.
[[nodiscard]] int row_function(const Gate& gate);

/// Counts the gates of a network, equal functions of rows once.
class CostCounter {
 public:
  explicit CostCounter(const GateCosts& costs) : costs_(&costs) {}

  // Each returns what the gate adds to or takes from the cost.
  int add(const Gate& gate) { return counted(gate, 0, 1); }
  int remove(const Gate& gate) { return counted(gate, 1, -1); }

 private:
  int counted(const Gate& gate, int alone, int step) {
    const int cost = (*costs_)[gate.function];
    const int function = row_function(gate);
    if (function < 0) return cost;
    int& count = rows_with_[static_cast<std::size_t>(function)];
    const bool is_alone = count == alone;
    count += step;
    return is_alone ? cost : 0;
  }

  const GateCosts* costs_;
  std::array<int, 256> rows_with_{};
};

[[nodiscard]] int cost_of(const GateNetwork& network, const GateCosts& costs);

/// Removes gates that nothing reads and orders the others.
void sort_gates(GateNetwork& network);

}  // namespace thinbench::detail
