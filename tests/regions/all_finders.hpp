// Runs the reference and every variant that finds objects and holes.
#pragma once

#include <string>

#include "api/catalogue.hpp"
#include "holes.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {

/// Calls `check(regions, name)` with the result of the reference and of each available variant.
template <class Check>
void for_each_finder(const ConstImageView& image, const Check& check) {
  const reference::Regions found = reference::holes(image);
  check(Regions{found.objects, found.holes}, std::string("reference"));
  for (const auto& variant : detail::operation_of(detail::RegionsTask::holes).variants) {
    if (!unavailable_reason(variant, image.width).empty()) continue;
    const int threads = variant.threaded ? 3 : 1;
    const Options options = {
        .threads = threads, .isa = variant.isa, .technique = variant.technique};
    check(find_regions(image, options), std::string(technique_name(variant.technique)) + "/" +
                                            std::string(isa_name(variant.isa)) + "/" +
                                            std::to_string(threads));
  }
}

}  // namespace thinbench
