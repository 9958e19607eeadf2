// Objects and holes as JSON.
#pragma once

#include <cstdint>
#include <string>

#include "images/binarise.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {

/// All of `found`, which lie in `binary` and have at least `min_area` pixels; ends with a newline.
[[nodiscard]] std::string regions_json(const Regions& found, const BinaryImage& binary,
                                       const BinariseOptions& options, std::int64_t min_area);

}  // namespace thinbench
