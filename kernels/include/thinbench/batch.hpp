// Thinning of many small images of one size at once.
#pragma once

#include <memory>

#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {

/// Thins stacks of images of one size. Images up to 128 pixels wide are thinned many at a time, one
/// per lane of a vector register, by every parallel rule; other rules and wider images go one by
/// one, with the same result. Not for use by two threads at once; any number of batches may be used
/// side by side.
class ThinningBatch {
 public:
  /// `options` are those of thin(), but threads share the images of a stack, and a technique that
  /// is asked for thins them one by one. Throws as thin() does for sizes and options.
  ThinningBatch(Rule rule, Index width, Index height, const Options& options = {});
  ~ThinningBatch();
  ThinningBatch(ThinningBatch&&) noexcept;
  ThinningBatch& operator=(ThinningBatch&&) noexcept;
  ThinningBatch(const ThinningBatch&) = delete;
  ThinningBatch& operator=(const ThinningBatch&) = delete;

  /// Thins every image of `source` (0 is background, anything else foreground) into `destination`
  /// (0 and 255) and returns the largest number of iterations that one of them took, the last,
  /// which changed nothing, included; 0 for no images. Allocates nothing. The stacks are one and
  /// the same or share no byte; stacks whose images alternate in one buffer count as overlapping.
  ///
  /// Throws std::invalid_argument where the stacks do not have the size given above, counts or
  /// sizes differ or are negative, a row or an image does not fit its stride, a stack spans more
  /// memory than there is or has no data, and for a partial overlap. Nothing is written then.
  int operator()(const ConstStackView& source, const StackView& destination);

  /// Whether images are thinned one by one.
  [[nodiscard]] bool one_by_one() const;

 private:
  class Engine;
  class LaneEngine;
  class SingleEngine;

  Index width_;
  Index height_;
  std::unique_ptr<Engine> engine_;
};

/// The same in one call, for stacks that are thinned once. May be called from any number of
/// threads.
int thin_batch(Rule rule, const ConstStackView& source, const StackView& destination,
               const Options& options = {});

}  // namespace thinbench
