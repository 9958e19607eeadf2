#include "cli/edge_request.hpp"

#include <algorithm>

#include "cli/arguments.hpp"

namespace thinbench {
namespace {

void invert(ByteImage& grey) {
  for (Index y = 0; y < grey.height(); ++y) {
    std::uint8_t* row = grey.view().row(y);
    for (Index x = 0; x < grey.width(); ++x) row[x] = static_cast<std::uint8_t>(255 - row[x]);
  }
}

}  // namespace

void add_edge_thresholds(CLI::App& app, EdgeRequest& request) {
  add_value(app, "--gradient-threshold,--p1", request.gradient_threshold,
            "P1 of the paper: an edge has a greater gradient, 0 to 255",
            whole_number(0, kMaxThreshold), "N")
      ->capture_default_str();
  add_value(app, "--brightness-threshold,--p2", request.brightness_threshold,
            "P2 of the paper: beside an edge the background is brighter, 0 to 255 (default: "
            "from --threshold)",
            whole_number(0, kMaxThreshold), "N");
}

EdgeThresholds prepare_for_edges(ByteImage& grey, const BinaryImage& binary,
                                 const EdgeRequest& request) {
  const bool is_bright = binary.foreground == Foreground::bright;
  if (is_bright) invert(grey);
  const int highest = std::max(is_bright ? 255 - binary.threshold : binary.threshold - 1, 0);
  return {request.gradient_threshold, request.brightness_threshold.value_or(highest)};
}

}  // namespace thinbench
