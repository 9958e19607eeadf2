#include "compile/slots.hpp"

#include <stdexcept>

namespace thinbench::detail {

SlotNetwork with_slots(const GateNetwork& network) {
  const std::size_t count = network.gates.size();
  std::vector<std::size_t> last_use(kWindowPixels + count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::uint16_t input : network.gates[i].inputs) last_use[input] = i;
  }
  last_use[static_cast<std::size_t>(network.output)] = count;
  SlotNetwork result = {network, {}, 0};
  std::vector<std::uint16_t> slot_of(kWindowPixels + count);
  std::vector<std::uint16_t> free;
  const auto located = [&](std::size_t value) {
    return static_cast<std::uint16_t>(value < kWindowPixels ? value
                                                            : kWindowPixels + slot_of[value]);
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (free.empty()) free.push_back(static_cast<std::uint16_t>(result.slots++));
    // Taken before inputs are released: a gate never writes a slot that it reads.
    const std::uint16_t target = free.back();
    free.pop_back();
    Gate& gate = result.network.gates[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t value = gate.inputs[k];
      gate.inputs[k] = located(value);
      if (value >= kWindowPixels && last_use[value] == i) {
        free.push_back(slot_of[value]);
        last_use[value] = count + 1;  // released
      }
    }
    slot_of[kWindowPixels + i] = target;
    result.targets.push_back(target);
  }
  if (result.slots > kMaxSlots) throw std::length_error("the circuit is too large");
  result.network.output = located(static_cast<std::size_t>(network.output));
  return result;
}

}  // namespace thinbench::detail
