// The data that the kernels of the midpoint scan work on: every direction as columns of words.
#pragma once

#include "image/plane_view.hpp"
#include "thinbench/isa.hpp"
#include "thinbench/options.hpp"

namespace thinbench::detail {

/// Packed rows without a margin; memory holds whole groups of kGroupRows rows.
struct PackedRows {
  std::uint64_t* data = nullptr;
  Index rows = 0;
  Index words = 0;  // a multiple of the kernel's batch
  Index stride = 0;

  [[nodiscard]] std::uint64_t* row(Index y) const { return data + y * stride; }
};

/// The smallest width of a counter that distinguishes 0 to `longest`, of those that kernels are
/// compiled for. A counter of b bits has 2^b - 1 states; no image has 2^41 pixels.
constexpr int counter_bits(Index longest) {
  for (const int bits : {7, 9, 11, 15, 41}) {
    if (longest < (Index{1} << bits) - 1) return bits;
  }
  return 0;
}

/// A direction as columns: the scan finds runs downwards and replaces pixels by marks.
struct DirectionBuffer {
  PackedRows pixels;
  std::uint64_t* checkpoints = nullptr;  // see kChunkRows
  int bits = 0;                          // of the counters
};

/// Counters are stored once per chunk of rows and recomputed from there.
inline constexpr Index kChunkRows = 32;

/// Rows are prepared and merged in groups: 64 rows make one word of transposed rows.
inline constexpr Index kGroupRows = kWordBits;

/// Everything for one image. Columns are scanned in the source and marked in the target; the other
/// directions are copies. Rows are transposed. For diagonals, row y is rotated by y pixels in a
/// ring wider than the image, so that at least one background pixel separates two diagonals.
struct ScanWork {
  Directions directions;
  ConstBitPlaneView source;
  BitPlaneView target;
  /// Rows to be rotated, each stored twice, so that a rotation is a read at an offset: kGroupRows
  /// of them, or all rows where several threads rotate. Row y is at y % rows.
  PackedRows rings;
  DirectionBuffer buffers[kDirectionCount];

  [[nodiscard]] const DirectionBuffer& buffer(Direction direction) const {
    return buffers[static_cast<int>(direction)];
  }
};

/// The steps for one image, in this order: `prepare` all groups of rows, `scan` all batches of
/// columns in all chosen directions, `merge` all groups of rows. Threads may share each step.
struct ScanKernels {
  Index batch_words;
  void (*prepare)(const ScanWork& work, Index first_group, Index last_group);
  void (*scan)(const ScanWork& work, Direction direction, Index first_word);
  void (*merge)(const ScanWork& work, Index first_group, Index last_group);
};

/// Compiled once, for the baseline.
extern const ScanKernels kBitpackedScan;

/// The same on byte planes, in loops that compilers vectorise. `scratch` has
/// `scratch_words(width, height)` words on a cache line; its contents do not matter.
struct ByteScanKernels {
  void (*run)(Directions directions, const ConstBytePlaneView& source, const BytePlaneView& target,
              std::uint64_t* scratch);
  Index (*scratch_words)(Index width, Index height);
};

}  // namespace thinbench::detail
