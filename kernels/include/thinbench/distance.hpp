// The exact Euclidean distance transform.
#pragma once

#include <cstdint>
#include <limits>

#include "thinbench/export.h"
#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"

namespace thinbench {

/// The maximum width and height.
inline constexpr Index kMaxDistanceSide = 32767;
/// The value of every pixel of an image without background.
inline constexpr std::int32_t kNoBackground = std::numeric_limits<std::int32_t>::max();

/// The square of the Euclidean distance between the centres of each pixel and of the nearest
/// background pixel of the image:
///   distances(x, y) = min { (x - u)^2 + (y - v)^2 : source(u, v) = 0 }
/// Background has 0. What is outside the image does not count, as in SciPy's
/// distance_transform_edt; surround the image with background where it should. Exact integers.
///
/// Views must have the same size and share no byte; the stride of `distances` is in numbers. Takes
/// at most half a byte of memory per pixel and half a megabyte beside the views, and 1.5 megabytes
/// per thread.
/// Thread-safe for different destinations. Throws std::invalid_argument for a side above
/// kMaxDistanceSide, unsuitable views, threads out of range and an ISA that is not available, and
/// std::bad_alloc. Nothing is written if it throws.
///
/// Source: A. Meijster, J. Roerdink and W. Hesselink 2000, "A general algorithm for computing
/// distance transforms in linear time".
THINBENCH_API void squared_distances(ConstImageView source, LabelView distances,
                                     const Execution& execution = {});

/// How far the centres of neighbouring columns (x) and of neighbouring rows (y) are apart, in any
/// unit.
struct Spacing {
  double x = 1;
  double y = 1;

  friend constexpr bool operator==(const Spacing&, const Spacing&) = default;
};

/// The distances themselves, in the unit of the spacing s:
///   distances(x, y) = sqrt(min { ((x - u) s.x)^2 + ((y - v) s.y)^2 : source(u, v) = 0 })
/// and infinity in an image without background. Differs from the formula by at most 4e-16 of
/// the value; for pixels that are not square, the nearest is found in double precision.
///
/// Views, memory, threads and errors as squared_distances; std::invalid_argument also for a spacing
/// outside [1e-30, 1e30].
THINBENCH_API void distances(ConstImageView source, View<double> distances,
                             const Spacing& spacing = {}, const Execution& execution = {});

}  // namespace thinbench
