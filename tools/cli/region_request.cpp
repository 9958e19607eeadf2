#include "cli/region_request.hpp"

#include <utility>

#include "images/regions.hpp"
#include "thinbench/localise.hpp"

namespace thinbench {
namespace {

/// All of them. What is drawn on them needs the image of the objects.
struct AllRegions {
  Regions regions;
  ByteImage objects;
};

AllRegions by_foreground(BinaryImage binary, const RegionRequest& request) {
  Regions regions = find_regions(binary.image.view(), request.execution);
  return {std::move(regions), std::move(binary.image)};
}

AllRegions by_edges(ByteImage grey, BinaryImage binary, const RegionRequest& request) {
  const EdgeThresholds thresholds = prepare_for_edges(grey, binary, request.edges);
  binary.image = {};  // its memory is for the edges
  if (!request.draws) return {localise_objects(grey.view(), thresholds, request.execution), {}};
  Regions regions = localise_objects(grey.view(), thresholds, request.execution, grey.view());
  return {std::move(regions), std::move(grey)};
}

}  // namespace

GreyImage image_to_binarise(GreyImage& grey, const RegionRequest& request) {
  if (request.localises) grey = in_bytes(std::move(grey));
  return request.localises || request.draws ? copy_of(grey) : std::move(grey);
}

DrawnRegions find_regions_in(GreyImage grey, BinaryImage binary, const ImagePage& page,
                             const RegionRequest& request) {
  const ForegroundChoice choice = choice_of(binary, request.binarise);
  DrawnRegions drawn = {
      {page, binary.image.width(), binary.image.height(), choice, {}, request.min_area}, {}, {}};
  if (request.draws) {
    drawn.ground = request.localises ? copy_of(grey.bytes.view()) : in_bytes(std::move(grey)).bytes;
  }
  // NOLINTNEXTLINE(bugprone-use-after-move): where it localises, a copy was drawn on
  const AllRegions all = request.localises
                             ? by_edges(std::move(grey.bytes), std::move(binary), request)
                             : by_foreground(std::move(binary), request);
  drawn.found.regions = selected(all.regions, kept_regions(all.regions, request.min_area));
  if (request.draws) {
    drawn.overlay = regions_overlay(all.objects.view(), all.regions, request.min_area);
  }
  return drawn;
}

}  // namespace thinbench
