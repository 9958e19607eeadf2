// The state of the distance transform.
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "core/byte_image.hpp"
#include "core/thread_team.hpp"
#include "core/variant.hpp"
#include "distance/kernels.hpp"

namespace thinbench::detail {

struct DistanceParameters {};
using DistanceSetting = Setting<DistanceParameters>;

/// Owns 2 bytes per pixel, and a row of numbers per thread. Threads share columns, then rows.
class DistanceState {
 public:
  using Parameters = DistanceParameters;

  /// Rejects a side above kMaxDistanceSide.
  static void check(const DistanceParameters& parameters, Index width, Index height);

  DistanceState(const DistanceKernels& kernels, const DistanceSetting& setting);

  /// Both views must have the size of the setting.
  void run(const ConstImageView& source, const LabelView& distances);
  void run(const ConstImageView& source, const View<double>& distances, const Spacing& spacing);

 private:
  /// Calls `row(y, vertical distances, memory)` for every row.
  template <class Row>
  void for_rows(const ConstImageView& source, const Row& row);
  void write_roots(const std::uint16_t* vertical, DistanceRow& memory, double spacing,
                   double* distances, Index width);

  DistanceKernels kernels_;
  ThreadTeam team_;
  AlignedArray<std::uint16_t> vertical_;
  std::vector<DistanceRow> rows_;
};

using DistanceOperation = Operation<std::monostate, DistanceState>;

[[nodiscard]] const DistanceOperation& distance_operation();

}  // namespace thinbench::detail
