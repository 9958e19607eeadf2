// Objects and holes as a list and as JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "cli/tables.hpp"
#include "images/binarise.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {

/// What the JSON says of the foreground.
struct ForegroundChoice {
  Foreground foreground;
  std::optional<double> threshold;  // nothing where it is local
  const char* method;               // "given", "otsu" or "local"
};

[[nodiscard]] ForegroundChoice choice_of(const BinaryImage& binary, const BinariseOptions& options);

/// What was found in an image file.
struct FoundRegions {
  ImagePage page;
  Index width;
  Index height;
  ForegroundChoice choice;
  Regions regions;  // of at least `min_area` pixels
  std::int64_t min_area;
};

/// For people. Ends with a newline.
[[nodiscard]] std::string regions_list(const Regions& found);
[[nodiscard]] nlohmann::ordered_json regions_json(const FoundRegions& found);

}  // namespace thinbench
