// What the kernels of the scanning skeleton work on: every direction as the columns of a sheet.
#pragma once

#include "thinbench/isa.hpp"
#include "image/plane_view.hpp"
#include "thinbench/options.hpp"

namespace thinbench::detail {

/// Packed rows without a margin, in memory for whole groups of rows.
struct Sheet {
  std::uint64_t* data = nullptr;
  Index rows = 0;
  Index words = 0;  // a whole number of the kernel's batches
  Index stride = 0;

  [[nodiscard]] std::uint64_t* row(Index y) const { return data + y * stride; }
};

/// How many bits a counter needs that tells apart 0 to `longest`, among the widths that kernels are
/// compiled for; a counter of b bits has 2^b - 1 states. No image has 2^41 pixels.
inline constexpr int kCounterBits[] = {7, 9, 11, 15, 41};

constexpr int counter_bits(Index longest) {
  for (const int bits : kCounterBits) {
    if (longest < (Index{1} << bits) - 1) return bits;
  }
  return 0;
}

/// One direction as columns: runs are found downwards, marks take the place of the pixels.
struct Turned {
  Sheet sheet;
  std::uint64_t* checkpoints = nullptr;  // see kChunkRows
  int bits = 0;                          // of the counters
};

/// Counters are stored once a chunk of rows and calculated again from there.
inline constexpr Index kChunkRows = 32;

/// Rows are prepared and merged in groups of this many: 64 rows make a word of turned rows.
inline constexpr Index kGroupRows = kWordBits;

constexpr Index group_count(Index rows) {
  return (rows + kGroupRows - 1) / kGroupRows;
}

/// Everything for one image. The sheet of kColumns is the source itself and its marks go to the
/// target; the others are copies: kRows transposed, diagonals with row y turned by y pixels round a
/// ring that is wider than the image, so that one light pixel at least parts two diagonals.
struct ScanWork {
  Directions directions;
  ConstBitPlaneView source;
  BitPlaneView target;
  /// Rows that are being turned, each stored twice, so that it can be read from any word as if it
  /// were a ring: kGroupRows of them, or all where several threads turn. Row y is at y % rows.
  Sheet rings;
  Turned turned[kDirectionCount];  // by direction
};

/// The steps for one image, each of which may be shared between threads, one after another:
/// `prepare` for all groups of rows, `sweep` for all batches of all chosen directions, `merge` for
/// all groups of rows.
struct ScanKernels {
  Index batch_words;
  void (*prepare)(const ScanWork& work, Index first_group, Index last_group);
  void (*sweep)(const ScanWork& work, Direction direction, Index first_word);
  void (*merge)(const ScanWork& work, Index first_group, Index last_group);
};

/// Compiled once, for the baseline.
extern const ScanKernels kBitpackedScan;

/// The same on byte planes, in loops that compilers vectorise. `scratch` holds
/// `scratch_words(width, height)` words on a cache line and may hold anything.
struct ByteScanKernels {
  void (*run)(Directions directions, const ConstBytePlaneView& source, const BytePlaneView& target,
              std::uint64_t* scratch);
  Index (*scratch_words)(Index width, Index height);
};

}  // namespace thinbench::detail
