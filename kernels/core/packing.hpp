// Conversion between the byte images of the public interface (0 is background, anything else is
// foreground; 255 is written) and the planes that kernels work on.
#pragma once

#include "core/exported.hpp"
#include "core/plane_view.hpp"
#include "core/thread_team.hpp"

namespace thinbench::detail {

/// Images of at least this many bytes are written with non-temporal stores:
/// docs/experiments.md#packing.
inline constexpr Index kNonTemporalBytes = Index{8} << 20;

/// Source and target have the same size. `read` writes all words or bytes of a row that hold
/// pixels, with zeros past the width. `write` writes exactly `width` bytes per row.
template <class T>
struct PlaneConversion {
  void (*read)(const ConstImageView& source, const PlaneView<T>& target);
  void (*write)(const ConstPlaneView<T>& source, const ImageView& target);
  /// As `write`, for a band of an image of at least kNonTemporalBytes.
  void (*write_non_temporal)(const ConstPlaneView<T>& source, const ImageView& target);
};

/// For packed bits here, for bytes in techniques/.
template <class T>
inline constexpr Features kGainsFrom<PlaneConversion<T>> = feature("avx2") | feature("avx512bw");

template <class T>
[[nodiscard]] const PlaneConversion<T>& plane_conversion(Isa isa) {
  return kernels_of<PlaneConversion<T>>(isa);
}

/// As `read`; threads share the rows.
template <class T>
void read_rows(const ThreadTeam& team, const PlaneConversion<T>& conversion,
               const ConstImageView& source, const PlaneView<T>& target) {
  team.for_ranges(source.height, [&](Index first, Index last) {
    conversion.read(rows_of_view(source, first, last), rows_of_view(target, first, last));
  });
}

}  // namespace thinbench::detail
