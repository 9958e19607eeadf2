// Thinning of binary images.
#pragma once

#include <memory>

#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {

namespace detail {
class ThinningState;
}  // namespace detail

/// Thins `source` (0 is background, anything else foreground) into `destination` (0 and 255) by a
/// rule. Returns the number of iterations, including the last one, which changed nothing. Outside
/// the image everything is background; see Border for the outermost pixels.
///
/// The two views have one size; they are the same image or share no pixel (views side by side in
/// one buffer have equal strides). Any number of threads may call it at once, on different
/// destinations.
///
/// Throws std::invalid_argument, with one sentence that names the value, for sizes that differ or
/// are negative, more than 2^40 pixels, a stride below the width, a null image, a partial overlap,
/// an option that is out of range or that the rule does not have, and where no variant fits;
/// std::bad_alloc where memory is short. Nothing is written then.
///
/// docs/thinning.md has the formulas, connectivity, invariants and sources of the rules.
int thin(Rule rule, ConstImageView source, ImageView destination, const Options& options = {});

/// Thins images of one size; owns all memory for it. One thread at a time may use a thinner;
/// several threads may use different thinners.
class Thinner {
 public:
  /// Throws as thin() does for sizes and options.
  Thinner(Rule rule, Index width, Index height, const Options& options = {});
  ~Thinner();
  Thinner(Thinner&&) noexcept;
  Thinner& operator=(Thinner&&) noexcept;
  Thinner(const Thinner&) = delete;
  Thinner& operator=(const Thinner&) = delete;

  /// As thin(), for views of the size given above. Allocates nothing.
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
