// A plan owns what one variant needs for images of one size, so that running it allocates nothing.
// This is the fast way into the edge operators; thinbench_edges.hpp has the convenient one.
#pragma once

#include <memory>

#include "edges/variant.hpp"

namespace thinbench::detail {

struct EdgeTables;

struct EdgePlanOptions {
  EdgeThresholds thresholds = {};
  int threads = 1;  // counts for threaded variants only
};

/// Runs one variant on images of one size. Not for use by two threads at once.
class EdgePlan {
 public:
  /// Throws std::invalid_argument where the variant cannot run here, the size is negative or has
  /// more than 2^40 pixels, a threshold is not in [0, 255] or threads is not in [1, kMaxThreads];
  /// std::bad_alloc where memory is short.
  EdgePlan(const EdgeOperation& operation, const EdgeVariant& variant, Index width, Index height,
           const EdgePlanOptions& options = {});
  ~EdgePlan();
  EdgePlan(EdgePlan&&) noexcept;
  EdgePlan& operator=(EdgePlan&&) noexcept;
  EdgePlan(const EdgePlan&) = delete;
  EdgePlan& operator=(const EdgePlan&) = delete;

  /// Writes the edges of `source` to `destination`, 255 on 0. The two do not overlap and have the
  /// size of the plan; nothing is checked here.
  void run(ConstImageView source, ImageView destination);

  /// For variants that write bits, the two steps of run: the edges as packed bits, which the plan
  /// keeps until the next call; and from there to bytes. Others throw std::logic_error.
  ConstBitPlaneView run_to_bits(ConstImageView source);
  void store(ImageView destination) const;

  /// For tests: whether everything outside the rows of the plan's plane is still zero.
  [[nodiscard]] bool margins_are_zero() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace thinbench::detail
