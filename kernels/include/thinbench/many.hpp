// Thinning of many images: stacks of one size, and lists of any sizes.
#pragma once

#include <memory>
#include <span>

#include "thinbench/export.h"
#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {

/// Thins stacks of images of one size. Parallel rules on images up to 128 pixels wide thin many
/// images at once, one per lane of a vector register; other rules and wider images are thinned one
/// by one, with the same result. Not thread-safe, but threads may use different ones
/// concurrently.
class THINBENCH_API StackThinner {
 public:
  /// Threads share the images of a stack. Of those of 2^20 pixels and more, each thread thins the
  /// same number; what is left is thinned one after another on all threads. Throws as thin() does
  /// for sizes and options.
  StackThinner(const Rule& rule, Index width, Index height, const Thinning& thinning = {},
               const Execution& execution = {});
  ~StackThinner();
  StackThinner(StackThinner&&) noexcept;
  StackThinner& operator=(StackThinner&&) noexcept;
  StackThinner(const StackThinner&) = delete;
  StackThinner& operator=(const StackThinner&) = delete;

  /// Thins every image of `source` (0 is background, anything else is foreground) into
  /// `destination` (0 and 255). Returns the maximum number of iterations over all images, including
  /// the last iteration, which changed nothing; 0 without images. Allocates memory only if more
  /// threads have work than in all calls before. The stacks must be the same or share no byte;
  /// stacks with interleaved images in one buffer count as overlapping.
  ///
  /// Throws std::invalid_argument for images that do not have the size given above, counts or sizes
  /// that differ or are negative, a row or an image that does not fit its stride, a stack that
  /// exceeds the address space or has no data, and a partial overlap. Nothing is written if it
  /// throws.
  int operator()(ConstStackView source, StackView destination);

 private:
  class Engine;

  Index width_;
  Index height_;
  std::unique_ptr<Engine> engine_;
};

/// Thins one stack. Thread-safe for different destinations.
THINBENCH_API int thin_stack(const Rule& rule, ConstStackView source, StackView destination,
                             const Thinning& thinning = {}, const Execution& execution = {});

/// Thins sources[i] into destinations[i] for every i, images of any sizes, with the same result as
/// thin() for each. Images of up to 2^14 pixels and up to 128 pixels wide are thinned many at once,
/// as by a StackThinner; with Border::keep and Border::foreground, and by rules that add pixels,
/// only those whose size recurs in the list.
///
/// Returns the maximum number of iterations over all images, including the last iteration, which
/// changed nothing; 0 without images. Threads share the images. Of those of 2^20 pixels and more,
/// those left after the same number for each thread, the smallest, are thinned one after another on
/// all threads. Takes memory for the largest image, per thread.
///
/// A destination is its source or shares no byte with any image of the list; sources may overlap
/// each other. Thread-safe for different destinations. Throws as thin() does, and
/// std::invalid_argument for lists of different lengths; then nothing is written. If it throws
/// std::bad_alloc, some destinations may be written.
THINBENCH_API int thin_many(const Rule& rule, std::span<const ConstImageView> sources,
                            std::span<const ImageView> destinations, const Thinning& thinning = {},
                            const Execution& execution = {});

}  // namespace thinbench
