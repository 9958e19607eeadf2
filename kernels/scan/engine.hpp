// The steps of the scanning skeleton for one word type; see sweep.hpp for what they cost.
#pragma once

#include "scan/sweep.hpp"
#include "scan/turning.hpp"

namespace thinbench {

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
      if (work.directions.has(Direction::kRows)) turn_rows(work, group, first, end);
      if (work.ring.rows > 0) make_ring(work, first, end);
      for (const Direction direction : {Direction::kDiagonals, Direction::kAntidiagonals}) {
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
      if (!work.directions.has(Direction::kColumns)) clear(work.target, first, end);
      if (work.directions.has(Direction::kRows)) merge_rows(work, group, first, end);
      for (const Direction direction : {Direction::kDiagonals, Direction::kAntidiagonals}) {
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

  /// The source's rows, once and again behind that; the ring may be longer than a row.
  static void make_ring(const ScanWork& work, Index first, Index end) {
    const ConstBitPlaneView source = work.source;
    const Sheet ring = work.ring;
    for (Index y = first; y < end; ++y) {
      for (Index i = 0; i < ring.words; i += kBatch) {
        const Word word =
            i < source.row_elements ? Traits::load(source.row(y) + i) : Traits::zero();
        Traits::store(ring.row(y) + i, word);
        Traits::store(ring.row(y) + i + ring.wrap, word);
      }
    }
  }

  static void turn_diagonals(const ScanWork& work, Direction direction, Index first, Index end) {
    const Sheet ring = work.ring;
    const Sheet sheet = sheet_of(work, direction);
    for (Index y = first; y < end; ++y) {
      const Index turn = turn_of(direction, y, ring.words);
      for (Index i = 0; i < ring.words; i += kBatch) {
        Traits::store(sheet.row(y) + i, turned_word<Word>(ring.row(y), ring.words, turn, i));
      }
    }
  }

  static void merge_diagonals(const ScanWork& work, Direction direction, Index first, Index end) {
    const Sheet sheet = sheet_of(work, direction);
    const BitPlaneView target = work.target;
    const Index words = target.row_elements < sheet.words ? target.row_elements : sheet.words;
    for (Index y = first; y < end; ++y) {
      const Index turn = turn_back_of(direction, y, sheet.words);
      std::uint64_t* row = target.row(y);
      for (Index i = 0; i < words; i += kBatch) {
        const Word marks = turned_word<Word>(sheet.row(y), sheet.words, turn, i);
        Traits::store(row + i, Traits::load(row + i) | marks);
      }
    }
  }

  static void turn_rows(const ScanWork& work, Index group, Index first, Index end) {
    const Sheet sheet = sheet_of(work, Direction::kRows);
    Blocks<Word> blocks;
    for (Index word = 0; word * kWordBits < sheet.rows; word += kBatch) {
      for (Index y = 0; y < kGroupRows; ++y) {
        const bool inside = first + y < end;
        blocks.set_row(y,
                       inside ? Traits::load(work.source.row(first + y) + word) : Traits::zero());
      }
      blocks.transpose();
      for (Index lane = 0; lane < lanes(sheet, word); ++lane) {
        const Index x = (word + lane) * kWordBits;
        const Index columns = sheet.rows - x < kWordBits ? sheet.rows - x : kWordBits;
        for (Index i = 0; i < columns; ++i) sheet.row(x + i)[group] = blocks.lane(i, lane);
      }
    }
  }

  static void merge_rows(const ScanWork& work, Index group, Index first, Index end) {
    const Sheet sheet = sheet_of(work, Direction::kRows);
    Blocks<Word> blocks;
    for (Index word = 0; word * kWordBits < sheet.rows; word += kBatch) {
      for (Index y = 0; y < kGroupRows; ++y) blocks.set_row(y, Traits::zero());
      for (Index lane = 0; lane < lanes(sheet, word); ++lane) {
        const Index x = (word + lane) * kWordBits;
        const Index columns = sheet.rows - x < kWordBits ? sheet.rows - x : kWordBits;
        for (Index i = 0; i < columns; ++i) blocks.lane(i, lane) = sheet.row(x + i)[group];
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

}  // namespace thinbench
