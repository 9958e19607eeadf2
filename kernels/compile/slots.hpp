// Circuits with memory for their values, as the interpreter executes them.
#pragma once

#include <cstdint>
#include <vector>

#include "compile/gate_network.hpp"

namespace thinbench::detail {

/// A network in as few memory slots as values are needed at once. Inputs below kWindowPixels are
/// pixels, input 9 + s is slot s, and gate i writes slot `targets[i]`.
struct SlotNetwork {
  GateNetwork network;
  std::vector<std::uint16_t> targets;
  int slots;
};
inline constexpr int kMaxSlots = 256;
/// Of so many slots the interpreter has the values on its stack, 32 KiB at most; of more on the
/// heap. Random tables need 34.
inline constexpr int kMaxSlotsOnStack = 64;
/// Throws std::length_error if kMaxSlots do not suffice.
[[nodiscard]] SlotNetwork with_slots(const GateNetwork& network);

}  // namespace thinbench::detail
