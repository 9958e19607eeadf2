// Objects and holes as a list, as JSON and as CSV.
#pragma once

#include <cstdint>
#include <string>

#include "images/binarise.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {

/// What was found in an image file.
struct FoundRegions {
  std::string file;
  Index width;
  Index height;
  Regions regions;  // of at least `min_area` pixels
  std::int64_t min_area;
};

/// What the JSON says of the foreground.
struct ForegroundChoice {
  Foreground foreground;
  std::optional<int> threshold;  // nothing where it is local
  const char* method;            // "given", "otsu" or "local"
};

[[nodiscard]] ForegroundChoice choice_of(const BinaryImage& binary, const BinariseOptions& options);

// All end with a newline.
[[nodiscard]] std::string regions_list(const Regions& found);
[[nodiscard]] std::string regions_json(const FoundRegions& found, const ForegroundChoice& choice);
/// A row for each object, each followed by its holes, after a row of names.
[[nodiscard]] std::string regions_csv(const FoundRegions& found);

}  // namespace thinbench
