// The data of the midpoint scan: every direction as columns of words.
#pragma once

#include "core/plane_view.hpp"
#include "thinbench/isa.hpp"
#include "thinbench/midpoint_scan.hpp"

namespace thinbench::detail {

/// Packed rows without a margin; memory holds whole groups of kGroupRows rows.
struct PackedRows {
  std::uint64_t* data = nullptr;
  Index rows = 0;
  Index words = 0;  // a multiple of the kernel's batch
  Index stride = 0;

  [[nodiscard]] std::uint64_t* row(Index y) const { return data + y * stride; }
};

/// The minimum compiled counter width that distinguishes 0 to `longest`. A counter of b bits has
/// 2^b - 1 states; no image has 2^41 pixels.
constexpr int counter_bits(Index longest) {
  for (const int bits : {7, 9, 11, 15, 41}) {
    if (longest < (Index{1} << bits) - 1) return bits;
  }
  return 0;
}

/// One direction as columns. The scan replaces pixels by marks.
struct DirectionBuffer {
  PackedRows pixels;
  std::uint64_t* checkpoints = nullptr;  // counters at the first row of each chunk
  int bits = 0;                          // width of the counters
};

/// Rows per chunk: counters are stored once per chunk and recomputed from there.
inline constexpr Index kChunkRows = 32;

/// Rows are prepared and merged in groups: 64 rows make one word of transposed rows.
inline constexpr Index kGroupRows = kWordBits;

/// All data for one image. Columns are read from the source and marked in the target; the other
/// directions have buffers. Rows are transposed. For diagonals, row y is rotated by y pixels in a
/// ring wider than the image, so that at least one background pixel separates two diagonals.
struct ScanWork {
  Directions directions;
  ConstBitPlaneView source;
  BitPlaneView target;
  /// Rows to rotate, each stored twice, so that a rotation is a read at an offset. Holds kGroupRows
  /// rows, or all rows if several threads rotate. Row y is at y % rows.
  PackedRows rings;
  DirectionBuffer buffers[kDirectionCount];

  [[nodiscard]] const DirectionBuffer& buffer(Direction direction) const {
    return buffers[static_cast<int>(direction)];
  }
};

/// The phases for one image, in this order: `prepare` all groups of rows, `scan` all batches of
/// columns in all chosen directions, `merge` all groups of rows. Threads may share each phase.
struct ScanKernels {
  Index batch_words;
  void (*prepare)(const ScanWork& work, Index first_group, Index last_group);
  void (*scan)(const ScanWork& work, Direction direction, Index first_word);
  void (*merge)(const ScanWork& work, Index first_group, Index last_group);
};

}  // namespace thinbench::detail
