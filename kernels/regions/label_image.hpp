// Images of labels: the region of every pixel.
//
// Cost: that of labelled_runs.hpp, and four bytes stored per pixel.
#pragma once

#include "regions/labelled_runs.hpp"
#include "thinbench/regions.hpp"

namespace thinbench::detail {

/// As label_regions(). The views must have the same size and at least one pixel.
[[nodiscard]] Regions paint_regions(const ConstImageView& source, const LabelView& labels);

/// As label_components().
[[nodiscard]] std::vector<Region> paint_eight_connected(const ConstImageView& source,
                                                        const LabelView& labels);
[[nodiscard]] std::vector<Region> paint_four_connected(const ConstImageView& source,
                                                       const LabelView& labels);

}  // namespace thinbench::detail
