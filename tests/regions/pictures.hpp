// Pictures written as text, and every way to look for holes.
#pragma once

#include <string>
#include <vector>

#include "holes.hpp"
#include "thinbench/regions.hpp"

namespace thinbench::holes_test {

/// '#' is dark; all lines have one length.
inline ByteImage picture(const std::vector<std::string>& lines) {
  ByteImage image(static_cast<Index>(lines.front().size()), static_cast<Index>(lines.size()));
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) {
      const char pixel = lines[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      image.at(x, y) = pixel == '#' ? 255 : 0;
    }
  }
  return image;
}

/// What each available variant finds, and the reference, with the name of the way.
template <class Check>
void with_every_way(const ConstImageView& image, const Check& check) {
  const reference::Regions plain = reference::holes(image);
  check(Regions{plain.objects, plain.holes}, "reference");
  for (const HolesVariant& variant : find_holes_operation("holes")->variants) {
    if (!unavailable_reason(facts_of(variant), image.width).empty()) continue;
    const int threads = variant.threaded ? 3 : 1;
    check(find_regions(image, {variant.technique, variant.isa, threads}),
          std::string(technique_name(variant.technique)) + "/" +
              std::string(isa_name(variant.isa)) + "/" + std::to_string(threads));
  }
}

}  // namespace thinbench::holes_test
