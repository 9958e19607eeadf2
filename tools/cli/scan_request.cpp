#include "cli/scan_request.hpp"

#include <string>

#include <fmt/format.h>

#include "cli/names.hpp"
#include "support/usage.hpp"

namespace thinbench {
namespace {

/// The directions named in a list such as "rows,columns".
Directions directions_named(const std::string& list) {
  Directions directions = kNoDirections;
  std::size_t end = 0;
  for (std::size_t start = 0; end != std::string::npos; start = end + 1) {
    end = list.find(',', start);
    const std::string name = list.substr(start, end - start);
    if (name.empty()) {
      throw UsageError("--directions: '" + list + "' has an empty name; known: " +
                       enumeration({kDirectionNames.begin(), kDirectionNames.end()}));
    }
    const Direction direction = direction_named(name);
    if (directions.has(direction)) {
      throw UsageError(fmt::format("--directions: '{}' names {} twice", list, name));
    }
    directions.add(direction);
  }
  return directions;
}

void reject_option(bool given, const char* option, const char* lacking) {
  if (given) throw UsageError(fmt::format("{}: {} has no {}", option, kScanOperation, lacking));
}

}  // namespace

void RequestedScan::run(const ImageView& image) const {
  midpoint_scan(image, image, directions, border, execution);
}

bool makes_scan(const ThinningRequest& request) {
  return request.rule == kScanOperation || request.rule == "midpoint_scan";
}

RequestedScan requested_scan(const ThinningRequest& request) {
  reject_option(request.thinning.max_iterations.has_value(), "--max-iterations", "iterations");
  reject_option(!request.weights.empty(), "--weights", "weights");
  reject_option(request.optimise, "--optimise", "tables");
  const Border border = request.thinning.border.value_or(Border::background);
  if (border == Border::foreground) {
    throw UsageError(
        fmt::format("{}: border: expected background or keep, got foreground", kScanOperation));
  }
  return {request.directions.empty() ? Directions{} : directions_named(request.directions), border,
          request.execution};
}

}  // namespace thinbench
