// Fills holes of packed images.
#pragma once

#include <optional>
#include <vector>

#include "regions/contact_labeller.hpp"
#include "regions/fill_kernels.hpp"

namespace thinbench::detail {

/// Works on images of one size. Floods the background, or labels its runs where that takes long or
/// areas of holes are asked for: then it takes another bit per pixel, and 16 bytes per run.
class HoleFiller {
 public:
  HoleFiller(Isa isa, const HoleFilling& filling);

  /// Writes objects with their holes. Does not write margins.
  void fill(const ConstBitPlaneView& image, const BitPlaneView& filled);

 private:
  void fill_runs(const ConstBitPlaneView& image, const BitPlaneView& filled);
  void choose_holes(const Background& background);

  const HoleKernels& kernels_;
  FloodBackground flood_;
  Connectivity background_;
  std::int64_t max_area_;
  std::optional<BackgroundRuns> runs_;  // once they are needed
  std::vector<std::uint64_t> chosen_;   // by run
};

}  // namespace thinbench::detail
