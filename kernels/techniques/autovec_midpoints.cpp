// The midpoint scan on bytes, in loops that compilers vectorise. Counts, for each pixel, the
// foreground pixels before and after it in its run; a row of counts is computed from the adjacent
// row. Diagonals are columns that shift by one pixel per row; rows are transposed and scanned as
// columns. Compiled per ISA at -O3.
#include <algorithm>
#include <limits>

#include "core/exported.hpp"
#include "core/layout.hpp"
#include "techniques/midpoints.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

using Bytes = const std::uint8_t* __restrict;

/// Sizes of the working memory for one image. Rows of counts have a background pixel on either
/// side; one extra row before the first is the outside, two after the last hold counts from below.
struct Scratch {
  static constexpr Index kExtraRows = 3;

  Index transposed_stride;
  Index transposed_bytes;
  Index count_bytes;

  static Scratch of(Index width, Index height) {
    const Index stride = padded_row_bytes(height);
    const Index counts =
        std::max((width + 2) * (height + kExtraRows), (height + 2) * (width + kExtraRows));
    const Index size = count_size(std::max(width, height));
    return {stride, stride * width, round_up(counts * size, static_cast<Index>(kAlignment))};
  }
  /// Bytes of a count, which must hold `longest` + 1.
  static constexpr Index count_size(Index longest) {
    if (longest < std::numeric_limits<std::uint16_t>::max()) return sizeof(std::uint16_t);
    return longest < std::numeric_limits<std::uint32_t>::max() ? sizeof(std::uint32_t)
                                                               : sizeof(std::uint64_t);
  }
  [[nodiscard]] Index transposed_words() const { return transposed_bytes / kWordBytes; }
  [[nodiscard]] Index words() const { return (2 * transposed_bytes + count_bytes) / kWordBytes; }

 private:
  static constexpr Index kWordBytes = sizeof(std::uint64_t);
};

/// Columns of an image that shift by `shift` pixels to the east per row.
template <class Count>
struct ShearedColumns {
  ConstBytePlaneView source;
  BytePlaneView target;
  Index shift;
  Count* counts;

  [[nodiscard]] Count* row(Index y) const { return counts + (y + 1) * (source.width + 2) + 1; }

  void mark() const {
    const Index height = source.height;
    clear(-1);
    for (Index y = 0; y < height; ++y) {
      clear_margins(y);
      count(source.row(y), row(y - 1) - shift, row(y));
    }
    Count* below = row(height);
    Count* here = row(height + 1);
    clear(height);
    clear(height + 1);
    for (Index y = height - 1; y >= 0; --y) {
      count(source.row(y), below + shift, here);
      mark_row(source.row(y), row(y), here, target.row(y));
      std::swap(below, here);
    }
  }

 private:
  void clear(Index y) const { std::fill_n(row(y) - 1, source.width + 2, Count{0}); }
  void clear_margins(Index y) const { row(y)[-1] = row(y)[source.width] = 0; }

  void count(Bytes pixels, const Count* __restrict neighbours, Count* __restrict here) const {
    for (Index x = 0; x < source.width; ++x) {
      here[x] = static_cast<Count>((neighbours[x] + 1) * pixels[x]);
    }
  }

  /// A midpoint is followed by as many pixels of its run as precede it, or by one more.
  void mark_row(Bytes pixels, const Count* __restrict preceding, const Count* __restrict following,
                std::uint8_t* __restrict marks) const {
    for (Index x = 0; x < source.width; ++x) {
      const auto excess = static_cast<Count>(following[x] - preceding[x]);
      marks[x] = static_cast<std::uint8_t>(marks[x] | (pixels[x] & (excess <= 1 ? 1 : 0)));
    }
  }
};

constexpr Index kBlock = 16;

struct Block {
  std::uint8_t row[kBlock][kBlock];
};

template <class Body>
[[gnu::always_inline]] inline void for_each_block(Index width, Index height, const Body& body) {
  for (Index top = 0; top < height; top += kBlock) {
    for (Index left = 0; left < width; left += kBlock) {
      body(left, top, std::min(kBlock, width - left), std::min(kBlock, height - top));
    }
  }
}

/// Combines row x of `to` with column x of `from`. Takes views by value because byte stores could
/// alias the fields of a reference: docs/experiments.md#word-scan.
template <class Combine>
void transpose(ConstBytePlaneView from, BytePlaneView to, const Combine& combine) {
  for_each_block(from.width, from.height, [=](Index left, Index top, Index width, Index height) {
    Block block = {};
    for (Index y = 0; y < height; ++y) std::copy_n(from.row(top + y) + left, width, block.row[y]);
    Block transposed;
    for (Index x = 0; x < kBlock; ++x) {
      for (Index y = 0; y < kBlock; ++y) transposed.row[x][y] = block.row[y][x];
    }
    for (Index x = 0; x < width; ++x) {
      std::uint8_t* row = to.row(left + x) + top;
      for (Index y = 0; y < height; ++y) row[y] = combine(row[y], transposed.row[x][y]);
    }
  });
}

template <class Count>
void scan(Directions directions, const ConstBytePlaneView& source, const BytePlaneView& target,
          std::uint64_t* scratch) {
  const Scratch sizes = Scratch::of(source.width, source.height);
  auto* counts = reinterpret_cast<Count*>(scratch + 2 * sizes.transposed_words());
  if (directions.has(Direction::columns)) ShearedColumns<Count>{source, target, 0, counts}.mark();
  if (directions.has(Direction::diagonals)) ShearedColumns<Count>{source, target, 1, counts}.mark();
  if (directions.has(Direction::antidiagonals))
    ShearedColumns<Count>{source, target, -1, counts}.mark();
  if (!directions.has(Direction::rows)) return;
  const auto transposed_plane = [&](std::uint64_t* memory) {
    return BytePlaneView{reinterpret_cast<std::uint8_t*>(memory), source.height, source.width,
                         sizes.transposed_stride, source.height};
  };
  const BytePlaneView transposed = transposed_plane(scratch);
  const BytePlaneView marks = transposed_plane(scratch + sizes.transposed_words());
  transpose(source, transposed, [](std::uint8_t, std::uint8_t pixel) { return pixel; });
  std::fill_n(marks.data, sizes.transposed_bytes, std::uint8_t{0});
  ShearedColumns<Count>{transposed, marks, 0, counts}.mark();
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
