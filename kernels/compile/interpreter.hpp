// Interprets programs on blocks of rows: one dispatch per instruction and block, so that its cost
// is shared by kBlockRows registers. Values stay in the L1 cache.
#pragma once

#include <array>
#include <utility>

#include "compile/program.hpp"
#include "scan/window.hpp"
#include "simd/word.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

inline constexpr Index kBlockRows = 8;

/// One instruction on a block.
template <class Word>
using BlockOperation = void (*)(Word* to, const Word* a, const Word* b, const Word* c);

template <class Word, int function>
void ternary_block(Word* to, const Word* a, const Word* b, const Word* c) {
  for (Index i = 0; i < kBlockRows; ++i) {
    to[i] = ternary(a[i], b[i], c[i], [](auto x, auto y, auto z) {
      decltype(x) sum = x ^ x;
      if constexpr ((function & 0x80) != 0) sum = sum | (x & y & z);
      if constexpr ((function & 0x40) != 0) sum = sum | (x & y & ~z);
      if constexpr ((function & 0x20) != 0) sum = sum | (x & ~y & z);
      if constexpr ((function & 0x10) != 0) sum = sum | (x & ~y & ~z);
      if constexpr ((function & 0x08) != 0) sum = sum | (~x & y & z);
      if constexpr ((function & 0x04) != 0) sum = sum | (~x & y & ~z);
      if constexpr ((function & 0x02) != 0) sum = sum | (~x & ~y & z);
      if constexpr ((function & 0x01) != 0) sum = sum | (~x & ~y & ~z);
      return sum;
    });
  }
}

template <class Word, Opcode opcode>
void binary_block(Word* to, const Word* a, const Word* b, const Word*) {
  for (Index i = 0; i < kBlockRows; ++i) {
    if constexpr (opcode == Opcode::conjunction) to[i] = a[i] & b[i];
    if constexpr (opcode == Opcode::disjunction) to[i] = a[i] | b[i];
    if constexpr (opcode == Opcode::difference) to[i] = ~a[i] & b[i];
    if constexpr (opcode == Opcode::exclusive) to[i] = a[i] ^ b[i];
    if constexpr (opcode == Opcode::complement) to[i] = ~a[i];
  }
}

/// The operations by code.
template <class Word>
constexpr auto block_operations() {
  if constexpr (TernaryGate<Word>::kOneInstruction) {
    return []<int... f>(std::integer_sequence<int, f...>) {
      return std::array<BlockOperation<Word>, 256>{&ternary_block<Word, f>...};
    }
    (std::make_integer_sequence<int, 256>{});
  } else {
    return []<int... o>(std::integer_sequence<int, o...>) {
      return std::array<BlockOperation<Word>, kOpcodes>{
          &binary_block<Word, static_cast<Opcode>(o)>...};
    }
    (std::make_integer_sequence<int, kOpcodes>{});
  }
}

/// The rows that a block reads, each with its neighbours: row i of the block is entry i + 1.
template <class Word>
struct BlockWindow {
  Word west[kBlockRows + 2];
  Word centre[kBlockRows + 2];
  Word east[kBlockRows + 2];

  [[gnu::always_inline]] void set(Index i, const RowTriple<Word>& row) {
    west[i] = row.west;
    centre[i] = row.centre;
    east[i] = row.east;
  }
  /// The last two rows become the first two.
  void move_down() {
    for (Index i = 0; i < 2; ++i) {
      west[i] = west[kBlockRows + i];
      centre[i] = centre[kBlockRows + i];
      east[i] = east[kBlockRows + i];
    }
  }
};

/// Executes the program on the window; returns the new pixels of its rows. `slots` has kBlockRows
/// words for each slot of the program.
template <class Word>
const Word* execute(const SlotProgram& program, const BlockWindow<Word>& window, Word* slots) {
  static constexpr auto operations = block_operations<Word>();
  const Word* const pixels[kWindowPixels] = {window.west,     window.centre,     window.east,
                                             window.west + 1, window.centre + 1, window.east + 1,
                                             window.west + 2, window.centre + 2, window.east + 2};
  const auto at = [&](std::uint16_t operand) {
    return operand < kWindowPixels ? pixels[operand]
                                   : slots + (operand - kWindowPixels) * kBlockRows;
  };
  const auto& instructions = program.program.instructions;
  for (std::size_t i = 0; i < instructions.size(); ++i) {
    const auto& [a, b, c] = instructions[i].operands;
    operations[instructions[i].code](slots + program.targets[i] * kBlockRows, at(a), at(b), at(c));
  }
  return at(static_cast<std::uint16_t>(program.program.output));
}

/// A ScanFunction. `Rows` is an access to rows.
template <class Rows>
std::uint64_t interpret(const void* bound, const ColumnScan& scan) {
  using Word = typename Rows::Word;
  using Traits = WordTraits<Word>;
  using Element = typename Traits::Element;
  constexpr auto bytes = static_cast<Index>(sizeof(Element));
  const auto& program = *static_cast<const SlotProgram*>(bound);
  const auto* source = static_cast<const Element*>(scan.source);
  auto* target = static_cast<Element*>(scan.target);
  const Index source_stride = scan.source_stride / bytes;
  const Index target_stride = scan.target_stride / bytes;
  const auto row = [&](Index y) {
    return Rows::at(source + y * source_stride, source_stride).row(0);
  };
  const Word fixed = scan.fixed == nullptr ? Traits::zero()
                                           : Traits::load(static_cast<const Element*>(scan.fixed));
  BlockWindow<Word> window = {};
  constexpr std::size_t alignment_bits = 8 * alignof(Word);
  const auto slot_words = static_cast<std::size_t>(program.slots * kBlockRows);
  auto* const slots =
      static_cast<Word*>(__builtin_alloca_with_align(slot_words * sizeof(Word), alignment_bits));
  window.set(0, row(-1));
  window.set(1, row(0));
  std::uint64_t changed_bands = 0;
  Word changed = Traits::zero();
  for (Index first = 0; first < scan.rows; first += kBlockRows) {
    const Index rows = scan.rows - first < kBlockRows ? scan.rows - first : kBlockRows;
    for (Index i = 0; i < rows; ++i) window.set(i + 2, row(first + i + 1));
    const Word* const next = execute(program, window, slots);
    for (Index i = 0; i < rows; ++i) {
      const Index y = first + i;
      const Word before = window.centre[i + 1];
      const Word difference = (next[i] ^ before) & ~fixed;
      Traits::store(target + y * target_stride, before ^ difference);
      changed = changed | difference;
      if ((y + 1) % scan.band_rows != 0 && y + 1 != scan.rows) continue;
      changed_bands |= std::uint64_t{Traits::any(changed)} << (y / scan.band_rows);
      changed = Traits::zero();
    }
    window.move_down();
  }
  return changed_bands;
}

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
