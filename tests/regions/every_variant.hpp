// Every way to find objects and holes.
#pragma once

#include <string>

#include "api/catalogue.hpp"
#include "holes.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {

/// Calls `check(regions, name)` with what the reference and each available variant finds.
template <class Check>
void for_every_way(const ConstImageView& image, const Check& check) {
  const reference::Regions plain = reference::holes(image);
  check(Regions{plain.objects, plain.holes}, std::string("reference"));
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
