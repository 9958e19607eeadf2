// Objects and holes of an image, by its foreground or by its edges: commands that list them take
// the same.
#pragma once

#include <cstdint>

#include "cli/edge_request.hpp"
#include "cli/region_formats.hpp"
#include "images/overlay.hpp"

namespace thinbench {

struct RegionRequest {
  bool localises = false;  // by edges
  EdgeRequest edges;       // of these
  BinariseOptions binarise;
  std::int64_t min_area = 1;
  bool draws = false;
  Execution execution;
};

struct DrawnRegions {
  FoundRegions found;
  ByteImage ground;  // what the overlay is drawn over; empty unless the request draws
  Overlay overlay;
};

/// The image to binarise: a copy of `grey` where find_regions_in() needs that, too, else itself.
/// Edges are found in 8 bits.
[[nodiscard]] GreyImage image_to_binarise(GreyImage& grey, const RegionRequest& request);

/// What is in `grey`, of which `binary` was made.
[[nodiscard]] DrawnRegions find_regions_in(GreyImage grey, BinaryImage binary,
                                           const ImagePage& page, const RegionRequest& request);

}  // namespace thinbench
