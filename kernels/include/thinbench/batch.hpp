// Thinning of many small images of one size.
#pragma once

#include <memory>

#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {

/// Thins stacks of images of one size. Parallel rules thin images up to 128 pixels wide many at a
/// time, one per lane of a vector register; other rules and wider images are thinned one by one,
/// with the same result. One thread at a time may use a batch; several threads may use different
/// batches.
class ThinningBatch {
 public:
  /// `options` are those of thin(), but threads share the images of a stack. With a technique
  /// given, images are thinned one by one. Throws as thin() does for sizes and options.
  ThinningBatch(Rule rule, Index width, Index height, const Options& options = {});
  ~ThinningBatch();
  ThinningBatch(ThinningBatch&&) noexcept;
  ThinningBatch& operator=(ThinningBatch&&) noexcept;
  ThinningBatch(const ThinningBatch&) = delete;
  ThinningBatch& operator=(const ThinningBatch&) = delete;

  /// Thins every image of `source` (0 is background, anything else foreground) into `destination`
  /// (0 and 255). Returns the largest number of iterations of an image, including the last one,
  /// which changed nothing; 0 without images. Allocates nothing. The stacks are the same or share
  /// no byte; stacks with interleaved images in one buffer count as overlapping.
  ///
  /// Throws std::invalid_argument for images of another size than above, counts or sizes that
  /// differ or are negative, a row or an image that does not fit its stride, a stack that exceeds
  /// the address space or has no data, and a partial overlap. Nothing is written then.
  int operator()(const ConstStackView& source, const StackView& destination);

  /// Whether images are thinned one by one instead of in lanes.
  [[nodiscard]] bool one_by_one() const;

 private:
  class Engine;

  Index width_;
  Index height_;
  std::unique_ptr<Engine> engine_;
};

/// The same for a single stack. Any number of threads may call it at once, on different
/// destinations.
int thin_batch(Rule rule, const ConstStackView& source, const StackView& destination,
               const Options& options = {});

}  // namespace thinbench
