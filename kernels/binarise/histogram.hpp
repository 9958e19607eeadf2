// Histograms of grey levels, and the classes that a threshold makes of them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "thinbench/image_view.hpp"

namespace thinbench::detail {

/// A count for each of 256 or 65536 levels; exact: counts are far below 2^53.
using Histogram = std::vector<double>;

/// Of grey levels in bytes or in 16 bits.
template <class T>
[[nodiscard]] Histogram histogram_of(const View<const T>& grey);

/// The share of the variance that a threshold leaves to the distance of the two means; 0 where
/// there is no variance.
[[nodiscard]] double separation(const Histogram& counts, int threshold);

/// The share of pixels whose level lies within a tenth of the distance of the two means from the
/// threshold; 0 with one class.
[[nodiscard]] double undecided_share(const Histogram& counts, int threshold);

/// The level of all pixels, if they have one.
[[nodiscard]] std::optional<int> only_level(const Histogram& counts);

/// Whether all levels are 0 or the highest.
[[nodiscard]] bool is_binary(const Histogram& counts);

/// The grey level from which pixels are bright by Otsu's method: the greatest variance between the
/// classes. The same operations in the same order as in OpenCV, so that ties and rounding agree.
[[nodiscard]] int otsu_threshold(const Histogram& counts);

}  // namespace thinbench::detail
