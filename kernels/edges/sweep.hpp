// The edge sweep: gradient, brightest neighbour and decision of a strip of columns in one walk down
// its rows. For ISA files only.
//
// A strip is as wide as a batch of bytes. It keeps what it needs of the rows above in registers, so
// that each row is loaded once, with unaligned loads for the neighbours to the west and the east;
// at the frame these come from the centre, its outermost lane repeated, and rows from the nearest
// row. Bands of rows are short enough for their part of the image to stay in the L1 or L2 cache
// between strips, and for the pages they touch to stay in the translation buffer.
#pragma once

#include "edges/kernels.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

inline constexpr Index kLanes = static_cast<Index>(ByteBatch::size);

/// 32 rows share the load of 2 or 4 rows beside them.
inline constexpr Index kStripRows = 32;

/// A strip jumps from row to row, more rows than the processor's prefetcher follows: so it asks for
/// the columns that strips to the east will read and write. On noise of 5100 x 4120 pixels that
/// took Sobel's time from 1.8 to 1.3 times that of a pixel at 510 x 412 (avx512), from 1.4 to 1.3
/// (avx2).
inline constexpr Index kColumnsAhead = 192;

/// A row's lanes with their neighbours: `at(k)` are the pixels k columns to the east.
template <int reach>
struct Columns {
  ByteBatch lanes[static_cast<std::size_t>(2 * reach + 1)];

  [[gnu::always_inline]] ByteBatch& at(int east) { return lanes[reach + east]; }
  [[gnu::always_inline]] const ByteBatch& at(int east) const { return lanes[reach + east]; }
};

/// `before` and `beyond` are how many columns of the image there are to the west and the east of
/// the lanes, `reach` at most.
template <int reach, int before, int beyond>
[[gnu::always_inline]] inline Columns<reach> load_columns(const std::uint8_t* from) {
  Columns<reach> row;
  row.at(0) = ByteBatch::load_unaligned(from);
  for (int k = 1; k <= reach; ++k) {
    row.at(-k) = k <= before ? ByteBatch::load_unaligned(from - k) : first_repeated(row.at(1 - k));
    row.at(k) = k <= beyond ? ByteBatch::load_unaligned(from + k) : last_repeated(row.at(k - 1));
  }
  return row;
}

/// The columns that a strip reads: row y is at `data + (y - base) * stride`, y from `lowest` to
/// `highest`.
struct StripSource {
  const std::uint8_t* data;
  Index stride;
  Index base;
  Index lowest;
  Index highest;

  [[gnu::always_inline]] const std::uint8_t* row(Index y) const {
    const Index inside = y < lowest ? lowest : y > highest ? highest : y;
    return data + (inside - base) * stride;
  }
};

/// The brightest of 3 x 3 pixels, `delay` rows after the last of them came in.
template <int delay>
struct Brightest {
  ByteBatch latest = ByteBatch(std::uint8_t{0});
  ByteBatch pair = latest;
  ByteBatch triple = latest;

  template <int reach>
  [[gnu::always_inline]] ByteBatch step(const Columns<reach>& row) {
    const ByteBatch across = xsimd::max(xsimd::max(row.at(-1), row.at(1)), row.at(0));
    const ByteBatch before = triple;
    triple = xsimd::max(pair, across);
    pair = xsimd::max(latest, across);
    latest = across;
    return delay == 0 ? triple : before;
  }
};

/// Lanes that are not 0 become 255 in a byte image.
struct ByteSink {
  ImageView target;

  [[gnu::always_inline]] void put(Index x, Index y, ByteBatch edges) const {
    std::uint8_t* to = target.row(y) + x;
    nonzero_bytes(edges).store_unaligned(to);
    __builtin_prefetch(to + kColumnsAhead, 1);
  }
};

/// The same where the image is narrower than a batch.
struct NarrowByteSink {
  ImageView target;

  void put(Index x, Index y, ByteBatch edges) const {
    std::uint8_t lanes[kLanes];
    nonzero_bytes(edges).store_unaligned(lanes);
    for (Index i = 0; i < target.width; ++i) target.row(y)[x + i] = lanes[i];
  }
};

/// Lanes that are not 0 become set bits. The last strip ends with the row and begins within a strip
/// that is there already: `dropped` lanes are those of that strip.
struct BitSink {
  BitPlaneView target;
  int dropped;
  std::uint64_t mask;

  [[gnu::always_inline]] void put(Index x, Index y, ByteBatch edges) const {
    const std::uint64_t bits = (nonzero_bits(edges) & mask) >> dropped;
    auto* bytes = reinterpret_cast<unsigned char*>(target.row(y));
    __builtin_memcpy(bytes + (x + dropped) / 8, &bits, static_cast<std::size_t>(kLanes / 8));
  }
};

/// Walks down a strip at column `x`. An operator's `step` takes a row and gives the lanes, not 0
/// where the gradient is above P1, of the row `reach` above.
template <class Operator, int before, int beyond, class Sink>
void sweep_strip(EdgeThresholds thresholds, StripSource source, Index x, EdgeRows rows, Sink sink) {
  constexpr int reach = Operator::kReach;
  const ByteBatch p2(static_cast<std::uint8_t>(thresholds.brightness_threshold));
  const auto columns = [&](Index y) __attribute__((always_inline)) {
    return load_columns<reach, before, beyond>(source.row(y));
  };
  Operator gradient(thresholds.gradient_threshold);
  Brightest<reach - 1> brightest;
  for (Index y = rows.first - reach; y < rows.first + reach; ++y) {
    const Columns<reach> row = columns(y);
    static_cast<void>(gradient.step(row));
    static_cast<void>(brightest.step(row));
  }
  for (Index y = rows.first; y < rows.last; ++y) {
    const Columns<reach> row = columns(y + reach);
    __builtin_prefetch(source.row(y + reach) + kColumnsAhead);
    const ByteBatch above_p1 = gradient.step(row);
    sink.put(x, y, xsimd::min(above_p1, excess(brightest.step(row), p2)));
  }
}

/// Chooses the strip's neighbours: min(reach, columns) of them on either side.
template <class Operator, class Sink, int before = 0, int beyond = 0>
void sweep_strip_between(EdgeThresholds thresholds, StripSource source, Index x, Index width,
                         EdgeRows rows, Sink sink) {
  if constexpr (before < Operator::kReach) {
    if (x > before) {
      return sweep_strip_between<Operator, Sink, before + 1, beyond>(thresholds, source, x, width,
                                                                     rows, sink);
    }
  }
  if constexpr (beyond < Operator::kReach) {
    if (width - kLanes - x > beyond) {
      return sweep_strip_between<Operator, Sink, before, beyond + 1>(thresholds, source, x, width,
                                                                     rows, sink);
    }
  }
  source.data += x;
  sweep_strip<Operator, before, beyond>(thresholds, source, x, rows, sink);
}

/// All strips of some rows; the last one ends with the row. Needs width >= kLanes.
template <class Operator, class MakeSink>
void sweep_rows(EdgeThresholds thresholds, const ConstImageView& image, EdgeRows rows,
                const MakeSink& make_sink) {
  const Index width = image.width;
  const StripSource source = {image.data, image.stride, 0, 0, image.height - 1};
  for (Index x = 0; x < width - kLanes; x += kLanes) {
    sweep_strip_between<Operator>(thresholds, source, x, width, rows, make_sink(0));
  }
  const Index tail = width % kLanes;
  const int dropped = tail == 0 ? 0 : static_cast<int>(kLanes - tail);
  sweep_strip_between<Operator>(thresholds, source, width - kLanes, width, rows,
                                make_sink(dropped));
}

/// Images narrower than a batch: their rows are copied, with all that lies outside, to a buffer as
/// wide as a batch and its neighbours.
template <class Operator, class Sink>
void sweep_narrow(EdgeThresholds thresholds, const ConstImageView& image, EdgeRows rows,
                  Sink sink) {
  constexpr Index reach = Operator::kReach;
  constexpr Index stride = kLanes + 2 * reach;
  std::uint8_t buffer[static_cast<std::size_t>(stride * (kStripRows + 2 * reach))];
  const StripSource all = {image.data, image.stride, 0, 0, image.height - 1};
  std::uint8_t* to = buffer;
  for (Index y = rows.first - reach; y < rows.last + reach; ++y, to += stride) {
    const std::uint8_t* from = all.row(y);
    for (Index i = 0; i < stride; ++i) {
      const Index x = i - reach;
      to[i] = from[x < 0 ? 0 : x < image.width ? x : image.width - 1];
    }
  }
  const StripSource copied = {buffer + reach, stride, rows.first - reach, rows.first - reach,
                              rows.last - 1 + reach};
  sweep_strip<Operator, static_cast<int>(reach), static_cast<int>(reach)>(thresholds, copied, 0,
                                                                          rows, sink);
}

/// Calls `sweep(rows)` for bands of kStripRows rows.
template <class Sweep>
[[gnu::always_inline]] inline void for_each_band(const EdgeRows& rows, const Sweep& sweep) {
  for (Index first = rows.first; first < rows.last; first += kStripRows) {
    sweep(EdgeRows{first, first + kStripRows < rows.last ? first + kStripRows : rows.last});
  }
}

template <class Operator>
void sweep_to_bytes(const EdgeThresholds& thresholds, ConstImageView source, ImageView target,
                    EdgeRows all) {
  for_each_band(all, [&](EdgeRows rows) {
    if (source.width < kLanes) {
      sweep_narrow<Operator>(thresholds, source, rows, NarrowByteSink{target});
    } else {
      sweep_rows<Operator>(thresholds, source, rows, [&](int) { return ByteSink{target}; });
    }
  });
}

template <class Operator>
void sweep_to_bits(const EdgeThresholds& thresholds, ConstImageView source, BitPlaneView target,
                   EdgeRows all) {
  constexpr std::uint64_t every_lane = ~std::uint64_t{0};
  for_each_band(all, [&](EdgeRows rows) {
    if (source.width < kLanes) {
      sweep_narrow<Operator>(thresholds, source, rows,
                             BitSink{target, 0, every_lane >> (kWordBits - source.width)});
    } else {
      sweep_rows<Operator>(thresholds, source, rows, [&](int dropped) {
        return BitSink{target, dropped, every_lane};
      });
    }
  });
}

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
