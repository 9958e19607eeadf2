// The midpoint scan on image files, as an operation of run and batch.
#pragma once

#include <string_view>

#include "cli/thinning_request.hpp"
#include "thinbench/midpoint_scan.hpp"

namespace thinbench {

inline constexpr std::string_view kScanOperation = "midpoint_scan";

struct RequestedScan {
  Directions directions;
  Border border;
  Execution execution;

  /// In place.
  void run(const ImageView& image) const;
};

/// Whether it is named.
[[nodiscard]] bool makes_scan(const ThinningRequest& request);

/// Throws UsageError for what does not apply to the scan.
[[nodiscard]] RequestedScan requested_scan(const ThinningRequest& request);

}  // namespace thinbench
