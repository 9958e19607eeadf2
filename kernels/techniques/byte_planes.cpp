#include "techniques/byte_planes.hpp"

#include <cstring>

namespace thinbench::detail {
namespace {

/// The bit of pixel x in its byte.
int bit_of(Index x, BitOrder order) {
  const int bit = static_cast<int>(x % 8);
  return order == BitOrder::msb_first ? 7 - bit : bit;
}

}  // namespace

// Rows without pixels may have no memory.

void read_packed(const ConstPackedView& source, const BytePlaneView& target) {
  if (source.width == 0) return;
  for (Index y = 0; y < source.height; ++y) {
    const std::uint8_t* bytes = source.row(y);
    std::uint8_t* row = target.row(y);
    for (Index x = 0; x < source.width; ++x) row[x] = bytes[x / 8] >> bit_of(x, source.order) & 1;
  }
}

void write_packed(const ConstBytePlaneView& source, const PackedView& target) {
  if (source.width == 0) return;
  for (Index y = 0; y < source.height; ++y) {
    const std::uint8_t* row = source.row(y);
    std::uint8_t* bytes = target.row(y);
    std::memset(bytes, 0, static_cast<std::size_t>(packed_row_bytes(source.width)));
    for (Index x = 0; x < source.width; ++x) {
      bytes[x / 8] = static_cast<std::uint8_t>(bytes[x / 8] | row[x] << bit_of(x, target.order));
    }
  }
}

void complement(const BytePlaneView& rows) {
  for (Index y = 0; y < rows.height; ++y) {
    std::uint8_t* const row = rows.row(y);
    for (Index x = 0; x < rows.width; ++x) row[x] ^= 1;
  }
}

}  // namespace thinbench::detail
