// Circuits for tables by Shannon's expansion.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "compile/gate_network.hpp"

namespace thinbench::detail {

/// The order in which an expansion splits by pixels.
using PixelOrder = std::array<int, kWindowPixels>;

/// A value of a network or its complement.
struct SignedValue {
  int value;
  bool inverted;
};

/// Adds gates to a network until it computes given tables. Reuses values that it knows.
class Decomposer {
 public:
  explicit Decomposer(const PixelOrder& order) : order_(order) {}

  /// Makes a value of the network known.
  void know(const WindowTable& table, int value) { known_.emplace(table.words, value); }
  /// Continues with a network whose values may be known.
  void set_network(GateNetwork network) { network_ = std::move(network); }

  /// nullopt if the network would exceed kMaxGates.
  [[nodiscard]] std::optional<SignedValue> add(const WindowTable& table);
  [[nodiscard]] GateNetwork take() { return std::move(network_); }

 private:
  [[nodiscard]] std::optional<SignedValue> found(const WindowTable& table) const;
  [[nodiscard]] std::vector<int> support(const WindowTable& table) const;
  [[nodiscard]] static Gate small_gate(const WindowTable& table, const std::vector<int>& pixels);

  PixelOrder order_;
  GateNetwork network_;
  std::map<std::array<std::uint64_t, 8>, int> known_;
};

}  // namespace thinbench::detail
