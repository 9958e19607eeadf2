// The scanning skeleton on bytes, in loops that compilers vectorise: counts of dark pixels before
// and behind each pixel, a row of counts from the row before, whatever the direction. Diagonals are
// columns that lean by one pixel a row; rows are transposed and scanned as columns. Compiled once
// for every instruction-set level at -O3.
#include <algorithm>
#include <limits>

#include "dispatch/exported.hpp"
#include "image/layout.hpp"
#include "midpoints/work.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

using Bytes = const std::uint8_t* __restrict;

/// Memory for one image. Rows of counts have a light pixel on either side; a row before the first
/// is for what lies outside, two behind the last are for the counts from below.
struct Scratch {
  static constexpr Index kExtraRows = 3;

  Index turned_stride;  // of a transposed image
  Index turned_bytes;
  Index count_bytes;

  static Scratch of(Index width, Index height) {
    const Index stride = padded_row_bytes(height);
    const Index counts =
        std::max((width + 2) * (height + kExtraRows), (height + 2) * (width + kExtraRows));
    const Index size = count_size(std::max(width, height));
    return {stride, stride * width, round_up(counts * size, static_cast<Index>(kAlignment))};
  }
  /// Bytes of a count that holds one more than the longest run.
  static constexpr Index count_size(Index longest) {
    if (longest < std::numeric_limits<std::uint16_t>::max()) return sizeof(std::uint16_t);
    return longest < std::numeric_limits<std::uint32_t>::max() ? sizeof(std::uint32_t)
                                                               : sizeof(std::uint64_t);
  }
  [[nodiscard]] Index turned_words() const { return turned_bytes / kWordBytes; }
  [[nodiscard]] Index words() const { return (2 * turned_bytes + count_bytes) / kWordBytes; }

 private:
  static constexpr Index kWordBytes = sizeof(std::uint64_t);
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
    const Index height = source.height;
    clear(-1);
    for (Index y = 0; y < height; ++y) {
      clear_margins(y);
      count(source.row(y), row(y - 1) - lean, row(y));
    }
    Count* behind = row(height);
    Count* spare = row(height + 1);
    clear(height);
    clear(height + 1);
    for (Index y = height - 1; y >= 0; --y) {
      count(source.row(y), behind + lean, spare);
      mark_row(source.row(y), row(y), spare, target.row(y));
      std::swap(behind, spare);
    }
  }

 private:
  void clear(Index y) const { std::fill_n(row(y) - 1, source.width + 2, Count{0}); }
  void clear_margins(Index y) const { row(y)[-1] = row(y)[source.width] = 0; }

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

constexpr Index kBlock = 16;

struct Block {
  std::uint8_t row[kBlock][kBlock];
};

/// `copy` moves a row of a whole block, whose length the compiler knows, or of a part.
template <class Copy>
[[gnu::always_inline]] inline void for_each_block(Index width, Index height, const Copy& copy) {
  for (Index top = 0; top < height; top += kBlock) {
    for (Index left = 0; left < width; left += kBlock) {
      copy(left, top, std::min(kBlock, width - left), std::min(kBlock, height - top));
    }
  }
}

/// Row x of `to` takes column x of `from` by `combine`. Views by value: stores of bytes through a
/// reference would make the compiler read them again and again.
template <class Combine>
void transpose(ConstBytePlaneView from, BytePlaneView to, const Combine& combine) {
  for_each_block(from.width, from.height, [=](Index left, Index top, Index width, Index height) {
    Block block = {};
    for (Index y = 0; y < height; ++y) std::copy_n(from.row(top + y) + left, width, block.row[y]);
    Block turned;
    for (Index x = 0; x < kBlock; ++x) {
      for (Index y = 0; y < kBlock; ++y) turned.row[x][y] = block.row[y][x];
    }
    for (Index x = 0; x < width; ++x) {
      std::uint8_t* row = to.row(left + x) + top;
      for (Index y = 0; y < height; ++y) row[y] = combine(row[y], turned.row[x][y]);
    }
  });
}

template <class Count>
void scan(Directions directions, const ConstBytePlaneView& source, const BytePlaneView& target,
          std::uint64_t* scratch) {
  const Scratch sizes = Scratch::of(source.width, source.height);
  auto* counts = reinterpret_cast<Count*>(scratch + 2 * sizes.turned_words());
  if (directions.has(Direction::columns)) Columns<Count>{source, target, 0, counts}.mark();
  if (directions.has(Direction::diagonals)) Columns<Count>{source, target, 1, counts}.mark();
  if (directions.has(Direction::antidiagonals)) Columns<Count>{source, target, -1, counts}.mark();
  if (!directions.has(Direction::rows)) return;
  const auto turned_plane = [&](std::uint64_t* memory) {
    return BytePlaneView{reinterpret_cast<std::uint8_t*>(memory), source.height, source.width,
                         sizes.turned_stride, source.height};
  };
  const BytePlaneView turned = turned_plane(scratch);
  const BytePlaneView marks = turned_plane(scratch + sizes.turned_words());
  transpose(source, turned, [](std::uint8_t, std::uint8_t pixel) { return pixel; });
  std::fill_n(marks.data, sizes.turned_bytes, std::uint8_t{0});
  Columns<Count>{turned, marks, 0, counts}.mark();
  transpose(marks, target,
            [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(a | b); });
}

void run(Directions directions, const ConstBytePlaneView& source, const BytePlaneView& target,
         std::uint64_t* scratch) {
  for (Index y = 0; y < target.height; ++y) {
    std::fill_n(target.row(y), target.row_elements, std::uint8_t{0});
  }
  switch (Scratch::count_size(std::max(source.width, source.height))) {
    case sizeof(std::uint16_t):
      return scan<std::uint16_t>(directions, source, target, scratch);
    case sizeof(std::uint32_t):
      return scan<std::uint32_t>(directions, source, target, scratch);
    default:
      return scan<std::uint64_t>(directions, source, target, scratch);
  }
}

Index scratch_words(Index width, Index height) {
  return Scratch::of(width, height).words();
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const ByteScanKernels Exported<ByteScanKernels, Isa::THINBENCH_ISA>::kKernels = {
    &run, &scratch_words};

}  // namespace thinbench::detail
