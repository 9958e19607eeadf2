// The phases of the midpoint scan for one word type. For their cost see column_scan.hpp.
#pragma once

#include "midpoints/column_scan.hpp"
#include "midpoints/transpose.hpp"

namespace thinbench::detail {

/// `isa` makes the symbols of each ISA distinct.
template <class Word, Isa isa>
struct ScanEngine {
  using Traits = WordTraits<Word>;
  static constexpr Index kBatch = Traits::kElements;

  static void prepare(const ScanWork& work, Index first_group, Index last_group) {
    for (Index group = first_group; group < last_group; ++group) {
      const Index first = group * kGroupRows;
      const Index end = end_of_group(work, group);
      if (work.directions.has(Direction::rows)) transpose_rows(work, group, first, end);
      if (work.rings.rows > 0 && !in_register(work)) make_rings(work, work.source, first, end);
      for (const Direction direction : {Direction::diagonals, Direction::antidiagonals}) {
        if (work.directions.has(direction)) rotate_rows(work, direction, first, end);
      }
    }
  }

  static void scan(const ScanWork& work, Direction direction, Index first_word) {
    const ScanColumn column = column_at(work, direction, first_word);
    switch (work.buffer(direction).bits) {
      case 7:
        return scan_column<7>(column);
      case 9:
        return scan_column<9>(column);
      case 11:
        return scan_column<11>(column);
      case 15:
        return scan_column<15>(column);
      default:
        return scan_column<41>(column);
    }
  }

  static void merge(const ScanWork& work, Index first_group, Index last_group) {
    for (Index group = first_group; group < last_group; ++group) {
      const Index first = group * kGroupRows;
      const Index end = end_of_group(work, group);
      if (!work.directions.has(Direction::columns)) clear(work.target, first, end);
      if (work.directions.has(Direction::rows)) merge_transposed(work, group, first, end);
      for (const Direction direction : {Direction::diagonals, Direction::antidiagonals}) {
        if (work.directions.has(direction)) merge_rotated(work, direction, first, end);
      }
    }
  }

  static constexpr ScanKernels kKernels = {kBatch, &prepare, &scan, &merge};

 private:
  template <int bits>
  static void scan_column(const ScanColumn& column) {
    MidpointScan<Word, bits>{column}.run();
  }

  static Index end_of_group(const ScanWork& work, Index group) {
    const Index end = (group + 1) * kGroupRows;
    return end < work.source.height ? end : work.source.height;
  }

  static void clear(const BitPlaneView& target, Index first, Index end) {
    for (Index y = first; y < end; ++y) {
      for (Index i = 0; i < target.row_elements; i += kBatch) {
        Traits::store(target.row(y) + i, Traits::zero());
      }
    }
  }

  static bool in_register(const ScanWork& work) {
    return RegisterRotl<Word, isa>::kAvailable && work.rings.words == kBatch;
  }

  static std::uint64_t* ring(const ScanWork& work, Index y) {
    return work.rings.row(y % work.rings.rows);
  }

  /// Stores each row twice, contiguously. A ring may be longer than a row.
  template <class Rows>
  static void make_rings(const ScanWork& work, const Rows& from, Index first, Index end) {
    const Index words = work.rings.words;
    std::uint64_t* to = ring(work, first);
    for (Index y = first; y < end; ++y, to += work.rings.stride) {
      for (Index i = 0; i < words; i += kBatch) {
        const bool inside = i < row_words(from);
        const Word word = inside ? Traits::load(from.row(y) + i) : Traits::zero();
        Traits::store(to + i, word);
        Traits::store(to + i + words, word);
      }
    }
  }
  static Index row_words(const ConstBitPlaneView& plane) { return plane.row_elements; }
  static Index row_words(const PackedRows& rows) { return rows.words; }

  static void rotate_rows(const ScanWork& work, Direction direction, Index first, Index end) {
    const PackedRows to = work.buffer(direction).pixels;
    DiagonalRotation rotation(to, direction, first);
    if constexpr (RegisterRotl<Word, isa>::kAvailable) {
      if (in_register(work)) {
        for (Index y = first; y < end; ++y, rotation.move_down()) {
          const Word row = Traits::load(work.source.row(y));
          Traits::store(to.row(y), RegisterRotl<Word, isa>::apply(row, rotation.forward()));
        }
        return;
      }
    }
    const std::uint64_t* from = ring(work, first);
    for (Index y = first; y < end; ++y, rotation.move_down(), from += work.rings.stride) {
      for (Index i = 0; i < to.words; i += kBatch) {
        Traits::store(to.row(y) + i, rotl_row<Word>(from, to.words, rotation.forward(), i));
      }
    }
  }

  static void merge_rotated(const ScanWork& work, Direction direction, Index first, Index end) {
    const PackedRows rows = work.buffer(direction).pixels;
    const BitPlaneView target = work.target;
    const Index words = target.row_elements < rows.words ? target.row_elements : rows.words;
    DiagonalRotation rotation(rows, direction, first);
    if constexpr (RegisterRotl<Word, isa>::kAvailable) {
      if (in_register(work)) {
        for (Index y = first; y < end; ++y, rotation.move_down()) {
          const Word marks =
              RegisterRotl<Word, isa>::apply(Traits::load(rows.row(y)), rotation.back());
          Traits::store(target.row(y), Traits::load(target.row(y)) | marks);
        }
        return;
      }
    }
    make_rings(work, rows, first, end);
    const std::uint64_t* from = ring(work, first);
    for (Index y = first; y < end; ++y, rotation.move_down(), from += work.rings.stride) {
      std::uint64_t* row = target.row(y);
      for (Index i = 0; i < words; i += kBatch) {
        const Word marks = rotl_row<Word>(from, rows.words, rotation.back(), i);
        Traits::store(row + i, Traits::load(row + i) | marks);
      }
    }
  }

  static void transpose_rows(const ScanWork& work, Index group, Index first, Index end) {
    const PackedRows to = work.buffer(Direction::rows).pixels;
    TransposableRows<Word> blocks;
    for (Index word = 0; word * kWordBits < to.rows; word += kBatch) {
      for (Index y = 0; y < kGroupRows; ++y) {
        const bool inside = first + y < end;
        blocks.set_row(y,
                       inside ? Traits::load(work.source.row(first + y) + word) : Traits::zero());
      }
      blocks.transpose();
      for (Index lane = 0; lane < lanes(to, word); ++lane) {
        blocks.store_lane(lane, to.row((word + lane) * kWordBits) + group, to.stride);
      }
    }
  }

  static void merge_transposed(const ScanWork& work, Index group, Index first, Index end) {
    const PackedRows rows = work.buffer(Direction::rows).pixels;
    TransposableRows<Word> blocks;
    for (Index word = 0; word * kWordBits < rows.rows; word += kBatch) {
      if (lanes(rows, word) < kBatch) blocks.clear();
      for (Index lane = 0; lane < lanes(rows, word); ++lane) {
        blocks.load_lane(lane, rows.row((word + lane) * kWordBits) + group, rows.stride);
      }
      blocks.transpose();
      for (Index y = first; y < end; ++y) {
        std::uint64_t* row = work.target.row(y) + word;
        Traits::store(row, Traits::load(row) | blocks.row(y - first));
      }
    }
  }

  /// The lanes of the batch at `word` that hold pixels.
  static Index lanes(const PackedRows& transposed, Index word) {
    const Index words = (transposed.rows + kWordBits - 1) / kWordBits - word;
    return words < kBatch ? words : kBatch;
  }
};

}  // namespace thinbench::detail
