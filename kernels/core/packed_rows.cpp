// Rows of packed bits and rows of words differ in the order of bits within bytes only. One word
// takes a load, a store and, with the highest bit first, 13 operations. That is far below the cost
// of thinning it, so one compilation serves all ISAs.
#include "core/packed_rows.hpp"

#include "core/byte_order.hpp"

namespace thinbench::detail {
namespace {

constexpr Index kWordBytes = kWordBits / 8;

/// Reverses the bits of every byte if the highest bit comes first.
template <BitOrder order>
std::uint64_t reordered(std::uint64_t word) {
  if constexpr (order == BitOrder::lsb_first) return word;
  constexpr std::uint64_t ones = 0x5555555555555555;
  constexpr std::uint64_t twos = 0x3333333333333333;
  constexpr std::uint64_t fours = 0x0F0F0F0F0F0F0F0F;
  word = (word >> 1 & ones) | (word & ones) << 1;
  word = (word >> 2 & twos) | (word & twos) << 2;
  return (word >> 4 & fours) | (word & fours) << 4;
}

template <BitOrder order>
void read_row(const std::uint8_t* bytes, Index width, std::uint64_t* row) {
  const Index words = width / kWordBits;
  const Index tail = width % kWordBits;
  for (Index i = 0; i < words; ++i) {
    row[i] = reordered<order>(load_bytes(bytes + i * kWordBytes));
  }
  if (tail == 0) return;
  const auto tail_bytes = static_cast<std::size_t>(packed_row_bytes(tail));
  const std::uint64_t word = load_bytes(bytes + words * kWordBytes, tail_bytes);
  row[words] = reordered<order>(word) & ((std::uint64_t{1} << tail) - 1);
}

template <BitOrder order>
void write_row(const std::uint64_t* row, Index width, std::uint8_t* bytes) {
  const Index words = width / kWordBits;
  const Index tail = width % kWordBits;
  for (Index i = 0; i < words; ++i) {
    store_bytes(bytes + i * kWordBytes, reordered<order>(row[i]));
  }
  if (tail == 0) return;
  const auto tail_bytes = static_cast<std::size_t>(packed_row_bytes(tail));
  store_bytes(bytes + words * kWordBytes, reordered<order>(row[words]), tail_bytes);
}

}  // namespace

// Rows without pixels may have no memory.

void read_packed(const ConstPackedView& source, const BitPlaneView& target) {
  if (source.width == 0) return;
  const auto read = source.order == BitOrder::msb_first ? &read_row<BitOrder::msb_first>
                                                        : &read_row<BitOrder::lsb_first>;
  for (Index y = 0; y < source.height; ++y) read(source.row(y), source.width, target.row(y));
}

void write_packed(const ConstBitPlaneView& source, const PackedView& target) {
  if (source.width == 0) return;
  const auto write = target.order == BitOrder::msb_first ? &write_row<BitOrder::msb_first>
                                                         : &write_row<BitOrder::lsb_first>;
  for (Index y = 0; y < source.height; ++y) write(source.row(y), source.width, target.row(y));
}

}  // namespace thinbench::detail
