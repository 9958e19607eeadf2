// The steps of the scanning skeleton for one word type; see sweep.hpp for what they cost.
#pragma once

#include "midpoints/register_turn.hpp"
#include "midpoints/sweep.hpp"
#include "midpoints/turning.hpp"

namespace thinbench::detail {

/// `isa` keeps apart what is compiled for different levels.
template <class Word, Isa isa>
struct ScanEngine {
  using Traits = WordTraits<Word>;
  static constexpr Index kBatch = Traits::kElements;

  static void prepare(const ScanWork& work, Index first_group, Index last_group) {
    for (Index group = first_group; group < last_group; ++group) {
      const Index first = group * kGroupRows;
      const Index end =
          first + kGroupRows < work.source.height ? first + kGroupRows : work.source.height;
      if (work.directions.has(Direction::rows)) turn_rows(work, group, first, end);
      if (work.rings.rows > 0 && !in_register(work)) make_rings(work, work.source, first, end);
      for (const Direction direction : {Direction::diagonals, Direction::antidiagonals}) {
        if (work.directions.has(direction)) turn_diagonals(work, direction, first, end);
      }
    }
  }

  static void sweep(const ScanWork& work, Direction direction, Index first_word) {
    const ScanColumn column = column_at(work, direction, first_word);
    switch (work.turned[static_cast<int>(direction)].bits) {
      case 7:
        return sweep_column<7>(column);
      case 9:
        return sweep_column<9>(column);
      case 11:
        return sweep_column<11>(column);
      case 15:
        return sweep_column<15>(column);
      default:
        return sweep_column<41>(column);
    }
  }

  static void merge(const ScanWork& work, Index first_group, Index last_group) {
    for (Index group = first_group; group < last_group; ++group) {
      const Index first = group * kGroupRows;
      const Index end =
          first + kGroupRows < work.source.height ? first + kGroupRows : work.source.height;
      if (!work.directions.has(Direction::columns)) clear(work.target, first, end);
      if (work.directions.has(Direction::rows)) merge_rows(work, group, first, end);
      for (const Direction direction : {Direction::diagonals, Direction::antidiagonals}) {
        if (work.directions.has(direction)) merge_diagonals(work, direction, first, end);
      }
    }
  }

  static constexpr ScanKernels kKernels = {kBatch, &prepare, &sweep, &merge};

 private:
  template <int bits>
  static void sweep_column(const ScanColumn& column) {
    ColumnSweep<Word, bits>{column}.run();
  }

  static const Sheet& sheet_of(const ScanWork& work, Direction direction) {
    return work.turned[static_cast<int>(direction)].sheet;
  }

  static void clear(const BitPlaneView& target, Index first, Index end) {
    for (Index y = first; y < end; ++y) {
      for (Index i = 0; i < target.row_elements; i += kBatch) {
        Traits::store(target.row(y) + i, Traits::zero());
      }
    }
  }

  static bool in_register(const ScanWork& work) {
    return RegisterTurn<Word>::kAvailable && work.rings.words == kBatch;
  }

  static std::uint64_t* ring(const ScanWork& work, Index y) {
    return work.rings.row(y % work.rings.rows);
  }

  /// Rows of a plane or a sheet, once and again behind that; a ring may be longer than a row.
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
  static Index row_words(const Sheet& sheet) { return sheet.words; }

  static void turn_diagonals(const ScanWork& work, Direction direction, Index first, Index end) {
    const Sheet sheet = sheet_of(work, direction);
    Turn turn(sheet, direction, first);
    if constexpr (RegisterTurn<Word>::kAvailable) {
      if (in_register(work)) {
        for (Index y = first; y < end; ++y, turn.move_down()) {
          const Word row = Traits::load(work.source.row(y));
          Traits::store(sheet.row(y), RegisterTurn<Word>::apply(row, turn.there()));
        }
        return;
      }
    }
    const std::uint64_t* from = ring(work, first);
    for (Index y = first; y < end; ++y, turn.move_down(), from += work.rings.stride) {
      for (Index i = 0; i < sheet.words; i += kBatch) {
        Traits::store(sheet.row(y) + i, turned_word<Word>(from, sheet.words, turn.there(), i));
      }
    }
  }

  static void merge_diagonals(const ScanWork& work, Direction direction, Index first, Index end) {
    const Sheet sheet = sheet_of(work, direction);
    const BitPlaneView target = work.target;
    const Index words = target.row_elements < sheet.words ? target.row_elements : sheet.words;
    Turn turn(sheet, direction, first);
    if constexpr (RegisterTurn<Word>::kAvailable) {
      if (in_register(work)) {
        for (Index y = first; y < end; ++y, turn.move_down()) {
          const Word marks = RegisterTurn<Word>::apply(Traits::load(sheet.row(y)), turn.back());
          Traits::store(target.row(y), Traits::load(target.row(y)) | marks);
        }
        return;
      }
    }
    make_rings(work, sheet, first, end);
    const std::uint64_t* from = ring(work, first);
    for (Index y = first; y < end; ++y, turn.move_down(), from += work.rings.stride) {
      std::uint64_t* row = target.row(y);
      for (Index i = 0; i < words; i += kBatch) {
        const Word marks = turned_word<Word>(from, sheet.words, turn.back(), i);
        Traits::store(row + i, Traits::load(row + i) | marks);
      }
    }
  }

  static void turn_rows(const ScanWork& work, Index group, Index first, Index end) {
    const Sheet sheet = sheet_of(work, Direction::rows);
    Blocks<Word> blocks;
    for (Index word = 0; word * kWordBits < sheet.rows; word += kBatch) {
      for (Index y = 0; y < kGroupRows; ++y) {
        const bool inside = first + y < end;
        blocks.set_row(y,
                       inside ? Traits::load(work.source.row(first + y) + word) : Traits::zero());
      }
      blocks.transpose();
      for (Index lane = 0; lane < lanes(sheet, word); ++lane) {
        blocks.store_lane(lane, sheet.row((word + lane) * kWordBits) + group, sheet.stride);
      }
    }
  }

  static void merge_rows(const ScanWork& work, Index group, Index first, Index end) {
    const Sheet sheet = sheet_of(work, Direction::rows);
    Blocks<Word> blocks;
    for (Index word = 0; word * kWordBits < sheet.rows; word += kBatch) {
      if (lanes(sheet, word) < kBatch) blocks.clear();
      for (Index lane = 0; lane < lanes(sheet, word); ++lane) {
        blocks.load_lane(lane, sheet.row((word + lane) * kWordBits) + group, sheet.stride);
      }
      blocks.transpose();
      for (Index y = first; y < end; ++y) {
        std::uint64_t* row = work.target.row(y) + word;
        Traits::store(row, Traits::load(row) | blocks.row(y - first));
      }
    }
  }

  /// The lanes of the batch at `word` that hold pixels.
  static Index lanes(const Sheet& sheet, Index word) {
    const Index words = (sheet.rows + kWordBits - 1) / kWordBits - word;
    return words < kBatch ? words : kBatch;
  }
};

}  // namespace thinbench::detail
