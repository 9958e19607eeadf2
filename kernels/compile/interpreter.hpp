// Interprets circuits on blocks of rows: one dispatch per gate and block, so that its cost
// is shared by kBlockRows registers. Values stay in the L1 cache.
#pragma once

#include <array>
#include <new>
#include <utility>

#include "compile/slots.hpp"
#include "scan/bound_rule.hpp"
#include "scan/window.hpp"
#include "simd/gate.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

inline constexpr Index kBlockRows = 8;

/// A gate on a block.
template <class Word>
using BlockGate = void (*)(Word* to, const Word* a, const Word* b, const Word* c);

template <class Word, std::uint8_t function>
void gate_on_block(Word* to, const Word* a, const Word* b, const Word* c) {
  for (Index i = 0; i < kBlockRows; ++i) to[i] = gate<function>(a[i], b[i], c[i]);
}

template <class Word, std::uint8_t function>
constexpr BlockGate<Word> block_gate() {
  if constexpr (is_native<Word>(function)) {
    return &gate_on_block<Word, function>;
  } else {
    return nullptr;
  }
}

/// The gates by function.
template <class Word>
constexpr auto block_gates() {
  return []<int... f>(std::integer_sequence<int, f...>) {
    return std::array<BlockGate<Word>, 256>{block_gate<Word, f>()...};
  }
  (std::make_integer_sequence<int, 256>{});
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

/// Evaluates the network on the window; returns the new pixels of its rows. `slots` has kBlockRows
/// words for each slot of the network.
template <class Word>
const Word* evaluate(const SlotNetwork& network, const BlockWindow<Word>& window, Word* slots) {
  static constexpr auto functions = block_gates<Word>();
  const Word* const pixels[kWindowPixels] = {window.west,     window.centre,     window.east,
                                             window.west + 1, window.centre + 1, window.east + 1,
                                             window.west + 2, window.centre + 2, window.east + 2};
  const auto at = [&](std::uint16_t input) {
    return input < kWindowPixels ? pixels[input] : slots + (input - kWindowPixels) * kBlockRows;
  };
  const auto& gates = network.network.gates;
  for (std::size_t i = 0; i < gates.size(); ++i) {
    const auto& [a, b, c] = gates[i].inputs;
    functions[gates[i].function](slots + network.targets[i] * kBlockRows, at(a), at(b), at(c));
  }
  return at(static_cast<std::uint16_t>(network.network.output));
}

/// Memory for slots.
struct HeapSlots {
  static constexpr std::align_val_t kAlignment{64};
  void* memory;

  explicit HeapSlots(std::size_t bytes)
      : memory(bytes == 0 ? nullptr : ::operator new(bytes, kAlignment)) {}
  HeapSlots(const HeapSlots&) = delete;
  HeapSlots& operator=(const HeapSlots&) = delete;
  ~HeapSlots() { ::operator delete(memory, kAlignment); }
};

/// A ScanFunction. `Rows` is an access to rows.
template <class Rows>
std::uint64_t interpret(const void* bound, const ColumnScan& scan) {
  using Word = typename Rows::Word;
  using Traits = WordTraits<Word>;
  using Element = typename Traits::Element;
  constexpr auto bytes = static_cast<Index>(sizeof(Element));
  const auto& network = *static_cast<const SlotNetwork*>(bound);
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
  const auto slot_bytes = static_cast<std::size_t>(network.slots * kBlockRows) * sizeof(Word);
  const bool on_stack = network.slots <= kMaxSlotsOnStack;
  const HeapSlots heap(on_stack ? 0 : slot_bytes);
  auto* const slots = static_cast<Word*>(
      on_stack ? __builtin_alloca_with_align(slot_bytes, alignment_bits) : heap.memory);
  window.set(0, row(-1));
  window.set(1, row(0));
  std::uint64_t changed_bands = 0;
  Word changed = Traits::zero();
  for (Index first = 0; first < scan.rows; first += kBlockRows) {
    const Index rows = scan.rows - first < kBlockRows ? scan.rows - first : kBlockRows;
    for (Index i = 0; i < rows; ++i) window.set(i + 2, row(first + i + 1));
    const Word* const next = evaluate(network, window, slots);
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
