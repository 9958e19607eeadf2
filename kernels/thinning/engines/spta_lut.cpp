// The original SPTA by table, pixel after pixel as published: 256 states of the neighbours before
// the pass times 256 of what is still there, 64 KB, of which a picture touches little. Eight
// pixels at a time are asked for edge points, 3 loads and 4 operations; an edge point costs eight
// loads, their packing and one look-up.
#include <array>
#include <cstring>

#include "thinning/engines/spta.hpp"

namespace thinbench::detail {
namespace {

// A pixel of the working image: bit 0 dark and not flagged, bit 1 dark before the pass.
constexpr std::uint8_t kDark = 3;
constexpr std::uint8_t kFlagged = 2;

/// Bit `scan`: whether a dark pixel is flagged. Place 256 before + now.
using Table = std::array<std::uint8_t, 65536>;

Table make_table() {
  Table table{};
  for (unsigned before = 0; before < 256; ++before) {
    for (unsigned now = 0; now < 256; ++now) {
      const bool left_right = spta_flags(SptaScan::left_right, before, now);
      const bool top_bottom = spta_flags(SptaScan::top_bottom, before, now);
      table[256 * before + now] = static_cast<std::uint8_t>(left_right | top_bottom << 1);
    }
  }
  return table;
}

/// `before` in the high byte, `now` in the low one.
unsigned state_at(const std::uint8_t* at, Index stride) {
  const std::uint8_t neighbours[] = {at[1],  at[1 - stride], at[-stride], at[-1 - stride],
                                     at[-1], at[stride - 1], at[stride],  at[stride + 1]};
  unsigned state = 0;
  for (unsigned i = 0; i < 8; ++i) {
    state |= (neighbours[i] & 1U) << i | (neighbours[i] & 2U) << (7 + i);
  }
  return state;
}

std::uint64_t eight_pixels(const std::uint8_t* from) {
  std::uint64_t word = 0;
  std::memcpy(&word, from, sizeof word);
  return word;
}

/// Of the eight pixels from `at`, bit 0 of the byte of each that is dark, not flagged and an edge
/// point of one of the two sides that lie `across` away.
std::uint64_t edge_points(const std::uint8_t* at, Index across) {
  const std::uint64_t inside = eight_pixels(at - across) & eight_pixels(at + across);
  return eight_pixels(at) & ~(inside >> 1) & 0x0101010101010101;
}

/// True where a pixel was flagged.
bool run_scan(SptaScan scan, const Table& table, const BytePlaneView& image) {
  const Index across = scan == SptaScan::left_right ? 1 : image.stride;
  bool flagged = false;
  for (Index y = 0; y < image.height; ++y) {
    std::uint8_t* row = image.row(y);
    for (Index x = 0; x < image.width; x += 8) {
      for (std::uint64_t left = edge_points(row + x, across); left != 0; left &= left - 1) {
        std::uint8_t* at = row + x + __builtin_ctzll(left) / 8;
        if ((table[state_at(at, image.stride)] >> static_cast<int>(scan) & 1) == 0) continue;
        *at = kFlagged;
        flagged = true;
      }
    }
  }
  return flagged;
}

/// Gives `to` where a pixel is `from`, else what it is.
void replace(const BytePlaneView& image, std::uint8_t from, std::uint8_t to) {
  for (Index y = 0; y < image.height; ++y) {
    std::uint8_t* row = image.row(y);
    for (Index x = 0; x < image.width; ++x) row[x] = row[x] == from ? to : row[x];
  }
}

int thin(Directions, const ConstBytePlaneView& source, const BytePlaneView& target,
         std::uint64_t*) {
  static const Table table = make_table();
  for (Index y = 0; y < source.height; ++y) {
    std::memcpy(target.row(y), source.row(y), static_cast<std::size_t>(source.row_elements));
  }
  replace(target, 1, kDark);
  int passes = 1;
  for (;; ++passes) {
    const bool left_right = run_scan(SptaScan::left_right, table, target);
    const bool top_bottom = run_scan(SptaScan::top_bottom, table, target);
    if (!left_right && !top_bottom) break;
    replace(target, kFlagged, 0);
  }
  replace(target, kDark, 1);
  return passes;
}

Index no_scratch(Index, Index) {
  return 0;
}

}  // namespace

constinit const ImageKernel<std::uint8_t> SptaKernels::kLut = {&thin, &no_scratch};

}  // namespace thinbench::detail
