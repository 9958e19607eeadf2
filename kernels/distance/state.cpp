#include "distance/state.hpp"

#include <algorithm>
#include <limits>

#include "core/exported.hpp"
#include "core/features.hpp"
#include "core/layout.hpp"
#include "thinbench/distance.hpp"

namespace thinbench::detail {
namespace {

/// Threads take columns by cache lines of bytes.
constexpr Index kColumns = 64;

Index stride_of(Index width) {
  return padded_row_bytes(width * 2) / 2;
}

std::unique_ptr<DistanceState> make_simd(const DistanceSetting& setting) {
  return std::make_unique<DistanceState>(kernels_of<DistanceKernels>(setting.isa), setting);
}

}  // namespace

DistanceState::DistanceState(const DistanceKernels& kernels, const DistanceSetting& setting)
    : kernels_(kernels),
      team_(setting.threads),
      vertical_(make_uninitialised<std::uint16_t>(
          static_cast<std::size_t>(stride_of(setting.width) * setting.height))),
      rows_(static_cast<std::size_t>(setting.threads), DistanceRow(setting.width)) {}

template <class Row>
void DistanceState::for_rows(const ConstImageView& source, const Row& row) {
  if (source.width == 0) return;  // such rows need no memory
  const VerticalDistances vertical = {vertical_.get(), stride_of(source.width)};
  team_.for_ranges((source.width + kColumns - 1) / kColumns, [&](Index first, Index last) {
    kernels_.columns(source, vertical, first * kColumns, std::min(last * kColumns, source.width));
  });
  const Index threads = team_.threads();
  team_.for_ranges(threads, [&](Index first, Index last) {
    for (Index i = first; i < last; ++i) {
      for (Index y = source.height * i / threads; y < source.height * (i + 1) / threads; ++y) {
        row(y, vertical.row(y), rows_[static_cast<std::size_t>(i)]);
      }
    }
  });
}

void DistanceState::run(const ConstImageView& source, const LabelView& distances) {
  for_rows(source, [&](Index y, const std::uint16_t* vertical, DistanceRow& memory) {
    kernels_.row(vertical, memory, distances.row(y), source.width);
  });
}

void DistanceState::run(const ConstImageView& source, const View<double>& distances,
                        const Spacing& spacing) {
  for_rows(source, [&](Index y, const std::uint16_t* vertical, DistanceRow& memory) {
    if (spacing.x == spacing.y) {
      write_roots(vertical, memory, spacing.x, distances.row(y), source.width);
    } else {
      spaced_row(vertical, memory, spacing, distances.row(y), source.width);
    }
  });
}

void DistanceState::write_roots(const std::uint16_t* vertical, DistanceRow& memory, double spacing,
                                double* distances, Index width) {
  std::int32_t* const squares = memory.found();
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
  static const auto& operation = kept<DistanceOperation>(
      {{}, "squared_distances", "squares of Euclidean distances to the background", [] {
         VariantList<DistanceState> list;
         for (const Isa isa :
              isas_with(feature("sse4.2") | feature("avx2") | feature("avx512bw"))) {
           list.add_with_threads("simd_search", isa, &make_simd, {1});
         }
         return list.take();
       }()});
  return operation;
}

}  // namespace thinbench::detail
