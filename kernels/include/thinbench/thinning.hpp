// Thinning of binary images.
#pragma once

#include <memory>

#include "thinbench/export.h"
#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {

namespace detail {
class ThinningState;
}  // namespace detail

/// Applies a rule to `source` (0 is background, anything else is foreground) and writes the result
/// to `destination` (0 and 255). Returns the number of iterations, including the last one if it
/// changed nothing. What is outside the image: see Border.
///
/// Both views must have the same size and be the same image or share no pixel. Views side by side
/// in one buffer must have equal strides. Thread-safe for different destinations.
///
/// Throws std::invalid_argument for sizes that differ or are negative, more than 2^40 pixels, a
/// stride below the width, a null image, a partial overlap, an option that is out of range, a rule
/// that may never end and has no limit, Border::foreground for a rule that is no function of 3 x 3
/// pixels, and an ISA that is not available; std::bad_alloc if memory runs out. Messages are one
/// line and name the value. Nothing is written if it throws.
///
/// docs/thinning.md has the formulas, connectivity, invariants and sources of the built-in rules.
THINBENCH_API int thin(const Rule& rule, ConstImageView source, ImageView destination,
                       const Thinning& thinning = {}, const Execution& execution = {});

/// Thins images of one size with memory allocated once. Not thread-safe, but threads may use
/// different thinners concurrently.
class THINBENCH_API Thinner {
 public:
  /// Throws as thin() does for sizes and options.
  Thinner(const Rule& rule, Index width, Index height, const Thinning& thinning = {},
          const Execution& execution = {});
  ~Thinner();
  Thinner(Thinner&&) noexcept;
  Thinner& operator=(Thinner&&) noexcept;
  Thinner(const Thinner&) = delete;
  Thinner& operator=(const Thinner&) = delete;

  /// As thin(), for views of the size given above. Allocates no memory.
  int operator()(ConstImageView source, ImageView destination);

 private:
  std::unique_ptr<detail::ThinningState> state_;
  Index width_;
  Index height_;
};

}  // namespace thinbench
