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
/// rule and returns the number of iterations, the last one, which changed nothing, included.
///
/// The two views have one size; they are the same image or share no pixel (views of one buffer that
/// lie side by side have equal strides). May be called from any number of threads at once, on
/// different destinations.
///
/// Throws std::invalid_argument, with one sentence that names the value, for sizes that differ or
/// are negative, more than 2^40 pixels, a stride below the width, a null image, a partial overlap,
/// an option outside its range or one that the rule does not know, and where no variant fits;
/// std::bad_alloc where memory is short. Nothing is written then.
///
/// The formulas and invariants of the rules are in docs/thinning.md.
int thin(Rule rule, ConstImageView source, ImageView destination, const Options& options = {});

/// Thins images of one size; owns all memory that this needs. Not for use by two threads at once;
/// any number of thinners may be used side by side.
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

  /// What was chosen.
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
