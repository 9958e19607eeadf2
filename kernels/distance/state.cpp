#include "distance/state.hpp"

#include <algorithm>
#include <limits>

#include "core/exported.hpp"
#include "core/layout.hpp"
#include "thinbench/distance.hpp"

namespace thinbench::detail {
namespace {

/// Threads take columns by cache lines.
constexpr Index kColumns = 64;

/// The vertical distances of a strip, which should remain in a second-level cache.
constexpr Index kStripBytes = Index{512} << 10;
constexpr Index kMinStripHeight = 8;

Index stride_of(Index width) {
  return padded_row_bytes(width * 2) / 2;
}

/// A strip for each thread, or more.
Index strip_height(const DistanceSetting& setting, int threads) {
  const Index fitting = kStripBytes / 2 / std::max<Index>(stride_of(setting.width), 1);
  const Index share = (setting.height + threads - 1) / threads;
  return std::max(kMinStripHeight, std::min(fitting, share));
}

/// Background that is `rows` farther away.
void extend(std::uint16_t* nearest, const std::uint16_t* beyond, Index rows, Index width) {
  for (Index x = 0; x < width; ++x) {
    nearest[x] = std::min(nearest[x], static_cast<std::uint16_t>(beyond[x] + rows));
  }
}

std::unique_ptr<DistanceState> make_simd(const DistanceSetting& setting) {
  return std::make_unique<DistanceState>(kernels_of<DistanceKernels>(setting.isa), setting);
}

}  // namespace

DistanceState::DistanceState(const DistanceKernels& kernels, const DistanceSetting& setting)
    : kernels_(kernels),
      team_(setting.threads),
      stride_(stride_of(setting.width)),
      strip_height_(strip_height(setting, team_.threads())),
      strips_((setting.height + strip_height_ - 1) / strip_height_),
      vertical_(make_uninitialised<std::uint16_t>(static_cast<std::size_t>(
          stride_ * std::min(strip_height_, setting.height) * team_.threads()))),
      edges_(make_uninitialised<std::uint16_t>(
          static_cast<std::size_t>(2 * (strips_ + 2) * stride_))) {
  rows_.reserve(static_cast<std::size_t>(team_.threads()));
  for (int i = 0; i < team_.threads(); ++i) rows_.emplace_back(setting.width);
  if (strips_ == 0) return;
  constexpr std::uint16_t far = kFarVertically - 1;  // a step from far
  std::fill_n(edges_of(0).above, stride_, far);
  std::fill_n(edges_of(strips_ - 1).below, stride_, far);
}

StripEdges DistanceState::edges_of(Index strip) const {
  std::uint16_t* const above = edges_.get() + 2 * (strip + 1) * stride_;
  return {above, above + stride_};
}

ConstImageView DistanceState::strip_of(const ConstImageView& source, Index strip) const {
  const Index y = strip * strip_height_;
  return {source.row(y), source.width, std::min(strip_height_, source.height - y), source.stride};
}

// By strips, although columns would need no second loop: half rows are read more slowly.
void DistanceState::find_edges(const ConstImageView& source) {
  team_.for_ranges(strips_, [&](Index first, Index last) {
    for (Index strip = first; strip < last; ++strip) {
      kernels_.edges(strip_of(source, strip),
                     {edges_of(strip + 1).above, edges_of(strip - 1).below});
    }
  });
  team_.for_ranges((source.width + kColumns - 1) / kColumns, [&](Index first, Index last) {
    extend_edges(source, first * kColumns, std::min(last * kColumns, source.width));
  });
}

void DistanceState::extend_edges(const ConstImageView& source, Index first, Index last) {
  for (Index strip = 1; strip < strips_; ++strip) {
    extend(edges_of(strip).above + first, edges_of(strip - 1).above + first, strip_height_,
           last - first);
  }
  for (Index strip = strips_ - 2; strip >= 0; --strip) {
    extend(edges_of(strip).below + first, edges_of(strip + 1).below + first,
           strip_of(source, strip + 1).height, last - first);
  }
}

template <class Row>
void DistanceState::for_rows(const ConstImageView& source, const Row& row) {
  if (source.width == 0) return;  // such rows need no memory
  if (strips_ > 1) find_edges(source);
  const Index threads = team_.threads();
  const Index room = stride_ * std::min(strip_height_, source.height);
  team_.for_ranges(threads, [&](Index first, Index last) {
    for (Index i = first; i < last; ++i) {
      const VerticalDistances vertical = {vertical_.get() + i * room, stride_};
      for (Index strip = strips_ * i / threads; strip < strips_ * (i + 1) / threads; ++strip) {
        const ConstImageView rows = strip_of(source, strip);
        kernels_.columns(rows, edges_of(strip), vertical);
        for (Index y = 0; y < rows.height; ++y) {
          row(strip * strip_height_ + y, vertical.row(y), rows_[static_cast<std::size_t>(i)]);
        }
      }
    }
  });
}

/// Calls `make(row of the result or memory instead)`; large results are written past the caches.
template <class T, class Make>
void DistanceState::write_row(const View<T>& result, Index y, T* memory, const Make& make) {
  constexpr auto bytes = static_cast<Index>(sizeof(T));
  if (result.width * result.height * bytes < kNonTemporalDistanceBytes) {
    make(result.row(y));
  } else {
    make(memory);
    kernels_.copy(memory, result.row(y), result.width * bytes);
  }
}

void DistanceState::run(const ConstImageView& source, const LabelView& distances) {
  for_rows(source, [&](Index y, const std::uint16_t* vertical, DistanceRow& memory) {
    write_row(distances, y, memory.squared_distances(),
              [&](std::int32_t* row) { kernels_.row(vertical, memory, row, source.width); });
  });
}

void DistanceState::run(const ConstImageView& source, const View<double>& distances,
                        const Spacing& spacing) {
  for_rows(source, [&](Index y, const std::uint16_t* vertical, DistanceRow& memory) {
    write_row(distances, y, memory.distances(), [&](double* row) {
      if (spacing.x == spacing.y) {
        write_roots(vertical, memory, spacing.x, row, source.width);
      } else {
        spaced_row(vertical, memory, spacing, row, source.width);
      }
    });
  });
}

void DistanceState::write_roots(const std::uint16_t* vertical, DistanceRow& memory, double spacing,
                                double* distances, Index width) {
  std::int32_t* const squares = memory.squared_distances();
  kernels_.row(vertical, memory, squares, width);
  if (squares[0] == kNoBackground) {
    std::fill_n(distances, width, std::numeric_limits<double>::infinity());
  } else {
    kernels_.roots(squares, spacing, distances, width);
  }
}

void DistanceState::check(const DistanceParameters&, Index width, Index height) {
  require(width <= kMaxDistanceSide && height <= kMaxDistanceSide, [&] {
    return "image size " + size_text(width, height) + " has a side above " +
           std::to_string(kMaxDistanceSide) + " pixels, the limit for distances";
  });
}

const DistanceOperation& distance_operation() {
  static const auto& operation = never_destroyed<DistanceOperation>(
      {{}, "squared_distances", "squares of Euclidean distances to the background", [] {
         VariantList<DistanceState> list;
         for (const Isa isa : isas_of<DistanceKernels>()) {
           list.add_with_threads("simd_search", isa, &make_simd, {1});
         }
         return list.take();
       }()});
  return operation;
}

}  // namespace thinbench::detail
