// The scanning skeleton on bytes, in loops that compilers vectorise: counts of dark pixels before
// and behind each pixel, a row of counts from the row before, whatever the direction. Diagonals are
// columns that lean by one pixel a row; rows are transposed and scanned as columns. Compiled once
// for every instruction-set level at -O3.
#include <algorithm>
#include <limits>

#include "core/layout.hpp"
#include "scan/work.hpp"

namespace thinbench {
namespace {

using Bytes = const std::uint8_t* __restrict;

/// Memory for one image. Rows of counts have a light pixel on either side; the first and the last
/// two rows are for what lies outside and for the counts from below.
struct Scratch {
  static constexpr Index kExtraRows = 4;

  Index turned_bytes;  // of a transposed image
  Index count_bytes;

  static constexpr bool has_short_runs(Index width, Index height) {
    return std::max(width, height) < std::numeric_limits<std::uint16_t>::max();
  }
  static Scratch of(Index width, Index height) {
    const Index turned = round_up(width * height, static_cast<Index>(kAlignment));
    const Index counts =
        std::max((width + 2) * (height + kExtraRows), (height + 2) * (width + kExtraRows));
    const Index size =
        has_short_runs(width, height) ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
    return {turned, round_up(counts * size, static_cast<Index>(kAlignment))};
  }
  [[nodiscard]] Index words() const {
    return (2 * turned_bytes + count_bytes) / static_cast<Index>(sizeof(std::uint64_t));
  }
};

/// Columns of an image that lean by `lean` pixels to the east a row.
template <class Count>
struct Columns {
  ConstBytePlaneView source;
  BytePlaneView target;
  Index lean;
  Count* counts;

  [[nodiscard]] Count* row(Index y) const { return counts + (y + 1) * (source.width + 2) + 1; }

  void mark() const {
    const Index stride = source.width + 2;
    const Index height = source.height;
    std::fill_n(counts, stride * (height + Scratch::kExtraRows), Count{0});
    for (Index y = 0; y < height; ++y) count(source.row(y), row(y - 1) - lean, row(y));
    Count* behind = row(height + 1);
    Count* spare = row(height + 2);
    for (Index y = height - 1; y >= 0; --y) {
      count(source.row(y), behind + lean, spare);
      mark_row(source.row(y), row(y), spare, target.row(y));
      std::swap(behind, spare);
    }
  }

 private:
  void count(Bytes dark, const Count* __restrict before, Count* __restrict here) const {
    for (Index x = 0; x < source.width; ++x) {
      here[x] = static_cast<Count>((before[x] + 1) * dark[x]);
    }
  }

  /// The centre has as many dark pixels before it as behind it, or one more behind it.
  void mark_row(Bytes dark, const Count* __restrict before, const Count* __restrict behind,
                std::uint8_t* __restrict marks) const {
    for (Index x = 0; x < source.width; ++x) {
      const auto more_behind = static_cast<Count>(behind[x] - before[x]);
      marks[x] = static_cast<std::uint8_t>(marks[x] | (dark[x] & (more_behind <= 1 ? 1 : 0)));
    }
  }
};

/// Blocks that fit the first-level cache, however long the rows are.
template <class Combine>
void transpose(const ConstBytePlaneView& from, const BytePlaneView& to, const Combine& combine) {
  constexpr Index kBlock = 32;
  for (Index top = 0; top < from.height; top += kBlock) {
    for (Index left = 0; left < from.width; left += kBlock) {
      const Index right = std::min(left + kBlock, from.width);
      const Index bottom = std::min(top + kBlock, from.height);
      for (Index x = left; x < right; ++x) {
        std::uint8_t* row = to.row(x);
        for (Index y = top; y < bottom; ++y) row[y] = combine(row[y], from.row(y)[x]);
      }
    }
  }
}

BytePlaneView turned_plane(std::uint64_t* memory, Index width, Index height) {
  return {reinterpret_cast<std::uint8_t*>(memory), width, height, width, width};
}

template <class Count>
void scan(Directions directions, const ConstBytePlaneView& source, const BytePlaneView& target,
          std::uint64_t* scratch) {
  const Scratch sizes = Scratch::of(source.width, source.height);
  const Index turned_words = sizes.turned_bytes / static_cast<Index>(sizeof(std::uint64_t));
  auto* counts = reinterpret_cast<Count*>(scratch + 2 * turned_words);
  if (directions.has(Direction::kColumns)) Columns<Count>{source, target, 0, counts}.mark();
  if (directions.has(Direction::kDiagonals)) Columns<Count>{source, target, 1, counts}.mark();
  if (directions.has(Direction::kAntidiagonals)) Columns<Count>{source, target, -1, counts}.mark();
  if (directions.has(Direction::kRows)) {
    const BytePlaneView turned = turned_plane(scratch, source.height, source.width);
    const BytePlaneView marks = turned_plane(scratch + turned_words, source.height, source.width);
    transpose(source, turned, [](std::uint8_t, std::uint8_t pixel) { return pixel; });
    std::fill_n(marks.data, marks.width * marks.height, std::uint8_t{0});
    Columns<Count>{turned, marks, 0, counts}.mark();
    transpose(marks, target,
              [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(a | b); });
  }
}

int thin(Directions directions, const ConstBytePlaneView& source, const BytePlaneView& target,
         std::uint64_t* scratch) {
  for (Index y = 0; y < target.height; ++y) {
    std::fill_n(target.row(y), target.row_elements, std::uint8_t{0});
  }
  if (Scratch::has_short_runs(source.width, source.height)) {
    scan<std::uint16_t>(directions, source, target, scratch);
  } else {
    scan<std::uint32_t>(directions, source, target, scratch);
  }
  return 1;
}

Index scratch_words(Index width, Index height) {
  return Scratch::of(width, height).words();
}

}  // namespace

template <>
constinit const ImageKernel<std::uint8_t> IsaScan<Isa::THINBENCH_ISA>::kAutovec = {&thin,
                                                                                   &scratch_words};

}  // namespace thinbench
