// Circuits made at run time, for functions of the 3 x 3 window.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "simd/gate.hpp"
#include "thinbench/rule.hpp"

namespace thinbench::detail {

/// The limit of a search.
inline constexpr int kMaxGates = 240;

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

/// What each of the 256 gates costs, and whether equal functions of different rows cost once: run
/// time code computes them once per row, compiled engines in every window.
struct GateCosts {
  std::array<std::uint8_t, 256> of;
  bool rows_once;
};

/// 1 for each gate: what processors with a three-input instruction pay.
[[nodiscard]] GateCosts ternary_costs(bool rows_once = true);

/// The number of two-input operations (and, or, xor, and-not) of a gate.
[[nodiscard]] GateCosts two_input_costs(bool rows_once = true);

/// For a gate of pixels of one row: its value for the west, centre and east pixel, as a truth table
/// with these as inputs a, b, c; else -1.
[[nodiscard]] int row_function(const Gate& gate);

/// Counts the cost of a network's gates.
class CostCounter {
 public:
  explicit CostCounter(const GateCosts& costs) : costs_(&costs) {}  // keeps a reference

  // Each returns what the gate adds to or takes from the cost.
  int add(const Gate& gate) { return counted(gate, 0, 1); }
  int remove(const Gate& gate) { return counted(gate, 1, -1); }

 private:
  int counted(const Gate& gate, int alone, int step) {
    const int cost = costs_->of[gate.function];
    if (!costs_->rows_once) return cost;
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
