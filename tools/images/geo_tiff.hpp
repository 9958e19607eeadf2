// Where the pixels of a map lie.
#pragma once

#include <optional>

#include "images/pixels.hpp"
#include "images/tiff_handle.hpp"

namespace thinbench {

/// Of the current page by GeoTIFF's tags; nothing without a transform.
[[nodiscard]] std::optional<GeoReference> geo_reference_of(const TiffHandle& tiff);

/// The number that stands for nothing on the current page, by GDAL's tag.
[[nodiscard]] std::optional<double> nodata_of(const TiffHandle& tiff);

}  // namespace thinbench
