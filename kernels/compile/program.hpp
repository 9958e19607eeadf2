// Circuits as instructions, which the interpreter and the code generator execute.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "compile/gate_network.hpp"

namespace thinbench::detail {

/// Of two operands; the difference is ~first & second, the complement that of the first.
enum class Opcode : std::uint8_t {
  conjunction,
  disjunction,
  difference,
  exclusive,
  complement,
};
inline constexpr int kOpcodes = 5;

/// Operands are numbers of values: 0 to 8 are the pixels of the window, 9 + i is the result of
/// instruction i.
struct Instruction {
  std::uint8_t code;  // the truth table of a Gate, or an Opcode
  std::array<std::uint16_t, 3> operands;
};

struct Program {
  bool ternary;  // whether codes are truth tables
  std::vector<Instruction> instructions;
  int output;  // the number of a value
};

[[nodiscard]] Program ternary_program(const GateNetwork& network);

/// The program in as few memory slots as values are needed at once. Operands below kWindowPixels
/// are pixels, operand 9 + s is slot s, and instruction i writes slot `targets[i]`.
struct SlotProgram {
  Program program;
  std::vector<std::uint16_t> targets;
  int slots;
};
inline constexpr int kMaxProgramSlots = 256;
/// Throws std::length_error if kMaxProgramSlots do not suffice.
[[nodiscard]] SlotProgram with_slots(const Program& program);

}  // namespace thinbench::detail
