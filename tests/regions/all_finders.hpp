// Runs the reference and every variant that finds objects and holes.
#pragma once

#include <string>

#include "holes.hpp"
#include "support/variant_of.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {

/// Calls `check(regions, name)` with the result of the reference and of each available variant.
template <class Check>
void for_each_finder(const ConstImageView& image, const Check& check) {
  const reference::Regions found = reference::holes(image);
  check(Regions{found.objects, found.holes}, std::string("reference"));
  constexpr auto kTask = detail::RegionsTask::holes;
  for (const detail::RegionsVariant& variant : detail::study::operation_of(kTask).variants) {
    if (!unavailable_reason(variant, image.width).empty()) continue;
    const auto state = make_state(variant, image.width, image.height, {kTask}, 3);
    state->load(image);
    state->compute();
    const detail::RegionLists lists = state->regions();
    check(Regions{{lists.objects.begin(), lists.objects.end()},
                  {lists.holes.begin(), lists.holes.end()}},
          name_of(variant));
  }
}

}  // namespace thinbench
