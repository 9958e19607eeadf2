// A plan owns the memory that one variant needs for images of one size. This is the fast way into
// the library for objects and holes; thinbench_holes.hpp has the convenient one.
#pragma once

#include "regions/variant.hpp"

namespace thinbench::detail {

/// What every plan that labels regions refuses; throws as HolesPlan does.
void check_regions_plan(const VariantFacts& variant, Index width, Index height, int threads);

/// Runs one variant on images of one size. Not for use by two threads at once.
///
/// Images: 0 is light, anything else dark; outside the image everything is light.
///
/// Memory: one bit a pixel for packed images, one byte for `lut`, five bytes for `union_find`;
/// filling takes one bit or byte a pixel more, and from packed images 8 bytes for each run. Regions
/// take 52 bytes for each provisional label (at most one in two pixels, one in some thousand on
/// pictures of parts). Labels and runs grow by need: an image with more of them than any before
/// makes run() allocate, a second run on it does not.
class HolesPlan {
 public:
  /// Throws std::invalid_argument where the variant cannot run here, the size is negative, a side
  /// is above 2^29 or the image above 2^32 pixels, or threads is not in [1, kMaxThreads];
  /// std::bad_alloc where memory is short.
  HolesPlan(const HolesOperation& operation, const HolesVariant& variant, Index width, Index height,
            int threads = 1);

  /// Computes; `source` must have the size of the plan, nothing is checked here. Throws
  /// std::bad_alloc.
  void run(const ConstImageView& source) {
    load(source);
    compute();
  }

  /// The two steps of run, for timing them apart: into the variant's own representation, and the
  /// work itself (the input is kept, so this may be repeated).
  void load(const ConstImageView& source) { state_->load(source); }
  void compute() { state_->compute(); }

  /// What the latest run found, by the operation's task: lists of regions that are valid until the
  /// next run, a number, or an image (0 and 255) of the plan's size. The others throw
  /// std::logic_error.
  [[nodiscard]] RegionLists regions() const { return state_->regions(); }
  [[nodiscard]] std::int64_t number() const { return state_->number(); }
  void store(const ImageView& destination) const { state_->store(destination); }

  /// For tests: whether everything outside the rows of the plan's planes is still zero.
  [[nodiscard]] bool margins_are_zero() const { return state_->margins_are_zero(); }

 private:
  std::unique_ptr<HolesState> state_;
};

}  // namespace thinbench::detail
