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

/// Owns, for each thread, a strip of vertical distances and a row of numbers. Where there are
/// several strips, a scan before finds how far background is beyond their edges, so that they are
/// independent. Threads share strips, and columns in between.
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
  [[nodiscard]] ConstImageView strip_of(const ConstImageView& source, Index strip) const;
  [[nodiscard]] StripEdges edges_of(Index strip) const;
  void find_edges(const ConstImageView& source);
  /// From strip to strip, for columns [first, last).
  void extend_edges(const ConstImageView& source, Index first, Index last);
  template <class T, class Make>
  void write_row(const View<T>& result, Index y, T* memory, const Make& make);
  void write_roots(const std::uint16_t* vertical, DistanceRow& memory, double spacing,
                   double* distances, Index width);

  DistanceKernels kernels_;
  ThreadTeam team_;
  Index stride_;        // of rows of vertical distances
  Index strip_height_;  // but for the last strip
  Index strips_;
  AlignedArray<std::uint16_t> vertical_;
  AlignedArray<std::uint16_t> edges_;  // of each strip, above and below
  std::vector<DistanceRow> rows_;
};

using DistanceOperation = Operation<std::monostate, DistanceState>;

[[nodiscard]] const DistanceOperation& distance_operation();

}  // namespace thinbench::detail
