#include "distance/state.hpp"

#include <algorithm>

#include "dispatch/exported.hpp"
#include "image/layout.hpp"

namespace thinbench::detail {
namespace {

/// Threads take columns by cache lines of bytes.
constexpr Index kColumns = 64;

Index stride_of(Index width) {
  return padded_row_bytes(width * 2) / 2;
}

std::unique_ptr<DistanceState> make_envelope(const DistanceSetting& setting) {
  const DistanceColumns columns = kernels_of<DistanceKernels>(setting.isa).columns;
  return std::make_unique<DistanceState>(DistanceKernels{columns, &envelope_row}, setting);
}

std::unique_ptr<DistanceState> make_simd(const DistanceSetting& setting) {
  return std::make_unique<DistanceState>(kernels_of<DistanceKernels>(setting.isa), setting);
}

}  // namespace

DistanceState::DistanceState(const DistanceKernels& kernels, const DistanceSetting& setting)
    : kernels_(kernels),
      team_(setting.threads),
      vertical_(make_aligned<std::uint16_t>(
          static_cast<std::size_t>(stride_of(setting.width) * setting.height))),
      rows_(static_cast<std::size_t>(setting.threads), DistanceRow(setting.width)) {}

void DistanceState::run(const ConstImageView& source, const LabelView& distances) {
  if (source.width == 0) return;  // such rows need no memory
  const VerticalDistances vertical = {vertical_.get(), stride_of(source.width)};
  team_.for_ranges((source.width + kColumns - 1) / kColumns, [&](Index first, Index last) {
    kernels_.columns(source, vertical, first * kColumns, std::min(last * kColumns, source.width));
  });
  const Index threads = team_.threads();
  team_.for_ranges(threads, [&](Index first, Index last) {
    for (Index i = first; i < last; ++i) {
      for (Index y = source.height * i / threads; y < source.height * (i + 1) / threads; ++y) {
        kernels_.row(vertical.row(y), rows_[static_cast<std::size_t>(i)], distances.row(y),
                     source.width);
      }
    }
  });
}

std::vector<DistanceVariant> distance_variants() {
  DistanceVariants list;
  list.add_with_threads(Technique::envelope, Isa::baseline, &make_envelope, {0});
  for (const Isa isa : all_isas()) {
    if (isa == Isa::avx512icl || isa == Isa::neon_sha3) continue;  // add no instruction used here
    list.add_with_threads(Technique::simd_32bit, isa, &make_simd, {1});
  }
  return list.take();
}

}  // namespace thinbench::detail
