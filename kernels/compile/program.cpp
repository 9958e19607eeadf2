#include "compile/program.hpp"

#include <stdexcept>

namespace thinbench::detail {

Program ternary_program(const GateNetwork& network) {
  Program program = {true, {}, network.output};
  for (const Gate& gate : network.gates) {
    const auto& [a, b, c] = gate.inputs;
    program.instructions.push_back({gate.function, {a, b, c}});
  }
  return program;
}

SlotProgram with_slots(const Program& program) {
  const std::size_t count = program.instructions.size();
  std::vector<std::size_t> last_use(kWindowPixels + count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::uint16_t operand : program.instructions[i].operands) last_use[operand] = i;
  }
  last_use[static_cast<std::size_t>(program.output)] = count;
  SlotProgram result = {program, {}, 0};
  std::vector<std::uint16_t> slot_of(kWindowPixels + count);
  std::vector<std::uint16_t> free;
  const auto located = [&](std::size_t value) {
    return static_cast<std::uint16_t>(value < kWindowPixels ? value
                                                            : kWindowPixels + slot_of[value]);
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (free.empty()) free.push_back(static_cast<std::uint16_t>(result.slots++));
    // Taken before operands are released: an instruction never writes a slot that it reads.
    const std::uint16_t target = free.back();
    free.pop_back();
    Instruction& instruction = result.program.instructions[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t value = instruction.operands[k];
      instruction.operands[k] = located(value);
      if (value >= kWindowPixels && last_use[value] == i) {
        free.push_back(slot_of[value]);
        last_use[value] = count + 1;  // released
      }
    }
    slot_of[kWindowPixels + i] = target;
    result.targets.push_back(target);
  }
  if (result.slots > kMaxProgramSlots) throw std::length_error("the circuit is too large");
  result.program.output = located(static_cast<std::size_t>(program.output));
  return result;
}

}  // namespace thinbench::detail
