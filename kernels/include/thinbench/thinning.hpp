// Thinning of binary images.
#pragma once

#include <memory>

#include "thinbench/export.h"
#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {

class CustomRule;

namespace detail {
class ThinningState;
}  // namespace detail

/// Thins `source` (0 is background, anything else is foreground) into `destination` (0 and 255) by
/// a rule. Returns the number of iterations, including the last one, which changed nothing.
/// Everything outside the image is background; for the outermost pixels see Border.
///
/// Both views must have the same size and be the same image or share no pixel. Views side by side
/// in one buffer must have equal strides. Thread-safe for different destinations.
///
/// Throws std::invalid_argument for sizes that differ or are negative, more than 2^40 pixels, a
/// stride below the width, a null image, a partial overlap, an option that is out of range or does
/// not apply to the rule, and if no variant fits; std::bad_alloc if memory runs out. Messages are
/// one line and name the value. Nothing is written if it throws.
///
/// docs/thinning.md has the formulas, connectivity, invariants and sources of the rules.
THINBENCH_API int thin(Rule rule, ConstImageView source, ImageView destination,
                       const Options& options = {});

/// Thins images of one size with memory allocated once. Not thread-safe, but threads may use
/// different thinners concurrently.
class THINBENCH_API Thinner {
 public:
  /// Throws as thin() does for sizes and options.
  Thinner(Rule rule, Index width, Index height, const Options& options = {});
  /// For apply(): `options` as there.
  Thinner(const CustomRule& rule, Index width, Index height, const Options& options = {});
  ~Thinner();
  Thinner(Thinner&&) noexcept;
  Thinner& operator=(Thinner&&) noexcept;
  Thinner(const Thinner&) = delete;
  Thinner& operator=(const Thinner&) = delete;

  /// As thin(), for views of the size given above. Allocates no memory.
  int operator()(ConstImageView source, ImageView destination);

  /// The chosen variant.
  [[nodiscard]] Technique technique() const { return technique_; }
  [[nodiscard]] Isa isa() const { return isa_; }

 private:
  std::unique_ptr<detail::ThinningState> state_;
  Index width_;
  Index height_;
  Technique technique_;
  Isa isa_;
};

}  // namespace thinbench
