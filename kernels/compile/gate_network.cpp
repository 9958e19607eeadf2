#include "compile/gate_network.hpp"

#include <algorithm>

#include "compile/two_input.hpp"

namespace thinbench::detail {

WindowTable gate_table(std::uint8_t function, const WindowTable& a, const WindowTable& b,
                       const WindowTable& c) {
  std::uint64_t constant[8];  // all bits of one row of the truth table
  for (int i = 0; i < 8; ++i) constant[i] = (function >> i & 1) != 0 ? ~std::uint64_t{0} : 0;
  const auto select = [](std::uint64_t s, std::uint64_t high, std::uint64_t low) {
    return low ^ (s & (high ^ low));
  };
  WindowTable table;
  for (std::size_t w = 0; w < table.words.size(); ++w) {
    const std::uint64_t x = c.words[w];
    const std::uint64_t y = b.words[w];
    const std::uint64_t low =
        select(y, select(x, constant[3], constant[2]), select(x, constant[1], constant[0]));
    const std::uint64_t high =
        select(y, select(x, constant[7], constant[6]), select(x, constant[5], constant[4]));
    table.words[w] = select(a.words[w], high, low);
  }
  return table;
}

const WindowTable& pixel_table(int pixel) {
  static const auto tables = [] {
    std::array<WindowTable, kWindowPixels> all;
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i] = make_window_table([i](std::size_t window) { return (window >> i & 1) != 0; });
    }
    return all;
  }();
  return tables[static_cast<std::size_t>(pixel)];
}

std::vector<WindowTable> tables_of(const GateNetwork& network) {
  std::vector<WindowTable> tables;
  tables.reserve(kWindowPixels + network.gates.size());
  for (int i = 0; i < kWindowPixels; ++i) tables.push_back(pixel_table(i));
  for (const Gate& gate : network.gates) {
    tables.push_back(gate_table(gate.function, tables[gate.inputs[0]], tables[gate.inputs[1]],
                                tables[gate.inputs[2]]));
  }
  return tables;
}

GateCosts ternary_costs(bool rows_once) {
  GateCosts costs = {{}, rows_once};
  costs.of.fill(1);
  return costs;
}

GateCosts two_input_costs(bool rows_once) {
  GateCosts costs = {{}, rows_once};
  for (std::size_t f = 0; f < costs.of.size(); ++f) {
    costs.of[f] = two_input_steps(static_cast<std::uint8_t>(f));
  }
  return costs;
}

int row_function(const Gate& gate) {
  const int row = gate.inputs[0] / 3;
  for (const std::uint16_t input : gate.inputs) {
    if (input >= kWindowPixels || input / 3 != row) return -1;
  }
  int function = 0;
  for (int pixels = 0; pixels < 8; ++pixels) {
    int index = 0;
    for (const std::uint16_t input : gate.inputs) {
      index = 2 * index + (pixels >> (2 - input % 3) & 1);
    }
    function |= (gate.function >> index & 1) << pixels;
  }
  return function;
}

int cost_of(const GateNetwork& network, const GateCosts& costs) {
  CostCounter counter(costs);
  int cost = 0;
  for (const Gate& gate : network.gates) cost += counter.add(gate);
  return cost;
}

namespace {

/// Numbers the gates that a value depends on in the order of their dependencies.
class Sorter {
 public:
  explicit Sorter(const GateNetwork& network)
      : network_(network), number_(kWindowPixels + network.gates.size(), -1) {
    for (int i = 0; i < kWindowPixels; ++i) number_[static_cast<std::size_t>(i)] = i;
  }

  int add(int value) {
    int& number = number_[static_cast<std::size_t>(value)];
    if (number >= 0) return number;
    Gate gate = network_.gates[static_cast<std::size_t>(value - kWindowPixels)];
    for (std::uint16_t& input : gate.inputs) input = static_cast<std::uint16_t>(add(input));
    number = kWindowPixels + static_cast<int>(sorted_.size());
    sorted_.push_back(gate);
    return number;
  }

  std::vector<Gate> take() { return std::move(sorted_); }

 private:
  const GateNetwork& network_;
  std::vector<int> number_;
  std::vector<Gate> sorted_;
};

}  // namespace

void sort_gates(GateNetwork& network) {
  Sorter sorter(network);
  network.output = sorter.add(network.output);
  network.gates = sorter.take();
}

}  // namespace thinbench::detail
