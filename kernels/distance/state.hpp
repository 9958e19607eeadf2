// The state of the distance transform.
#pragma once

#include <memory>
#include <vector>

#include "dispatch/variant.hpp"
#include "distance/kernels.hpp"
#include "image/byte_image.hpp"
#include "image/thread_team.hpp"

namespace thinbench::detail {

struct DistanceSetting {
  Isa isa;
  Index width;
  Index height;
  int threads;
};

/// Owns 2 bytes per pixel, and a row of numbers per thread. Threads share columns, then rows.
class DistanceState {
 public:
  using Setting = DistanceSetting;

  DistanceState(const DistanceKernels& kernels, const DistanceSetting& setting);

  /// Both views must have the size of the setting.
  void run(const ConstImageView& source, const LabelView& distances);

 private:
  DistanceKernels kernels_;
  ThreadTeam team_;
  AlignedArray<std::uint16_t> vertical_;
  std::vector<DistanceRow> rows_;
};

using DistanceVariant = Variant<DistanceState>;
using DistanceVariants = VariantList<DistanceState>;

[[nodiscard]] std::vector<DistanceVariant> distance_variants();

}  // namespace thinbench::detail
