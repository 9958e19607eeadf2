// Many small images of one size in one header: thin a whole stack of them at once.
#pragma once

#include <memory>
#include <string_view>

#include "image/stack.hpp"
#include "thinbench.hpp"

namespace thinbench {

/// Thins stacks of images of one size. Images up to 128 pixels wide are thinned many at a time, one
/// a lane of a vector register, where the operation is one of the rules `thin_...` other than the
/// sequential `thin_spta`; everything else is thinned one by one, with the same result. Not for use
/// by two threads at once.
class ThinningBatch {
 public:
  /// `options` are those of thin(), but threads share the images of a stack, and a technique that
  /// is asked for thins them one by one. Throws std::invalid_argument for a size that is negative
  /// or has more than 2^40 pixels, threads not in [1, kMaxThreads], and options that no variant
  /// fits; std::bad_alloc where memory is short.
  ThinningBatch(const ThinningOperation& operation, Index width, Index height,
                const ThinningOptions& options = {});
  /// The operation of this name; throws std::invalid_argument where there is none.
  ThinningBatch(std::string_view operation, Index width, Index height,
                const ThinningOptions& options = {});
  ~ThinningBatch();
  ThinningBatch(ThinningBatch&&) noexcept;
  ThinningBatch& operator=(ThinningBatch&&) noexcept;
  ThinningBatch(const ThinningBatch&) = delete;
  ThinningBatch& operator=(const ThinningBatch&) = delete;

  /// Thins every image of `source` (0 is light, anything else dark) into `destination` (0 and 255)
  /// and returns the largest number of passes that one of them took, the last, which changed
  /// nothing, included; 0 for no images. Allocates nothing. The stacks are one and the same or
  /// share no byte. Throws std::invalid_argument where they do not have the size given above, and
  /// for what check_stacks.hpp names; nothing was written then.
  int run(const ConstStackView& source, const StackView& destination);

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

/// The same in one call, for stacks that are thinned once.
int thin_batch(std::string_view operation, const ConstStackView& source,
               const StackView& destination, const ThinningOptions& options = {});

}  // namespace thinbench
