#include "thinbench/thinning.hpp"

#include "api/catalogue.hpp"
#include "image/checks.hpp"

namespace thinbench {

Thinner::Thinner(Rule rule, Index width, Index height, const Options& options)
    : width_(width), height_(height) {
  detail::require_size(width, height);
  const detail::ThinningOperation& operation = detail::operation_of(rule);
  const detail::ThinningVariant& variant = detail::choose(operation, width, height, options);
  const Index rows = width == 0 ? 0 : height;  // margins of rows without pixels would take memory
  state_ = detail::make_state(operation, variant, rows == 0 ? 0 : width, rows, options);
  technique_ = variant.technique;
  isa_ = variant.isa;
}

Thinner::Thinner(const CustomRule& rule, Index width, Index height, const Options& options)
    : width_(width), height_(height) {
  const detail::ThinningVariant& variant = detail::choose_custom(rule, width, height, options);
  const Index rows = width == 0 ? 0 : height;
  state_ = detail::make_custom_state(rule, variant, rows == 0 ? 0 : width, rows, options);
  technique_ = variant.technique;
  isa_ = variant.isa;
}

Thinner::~Thinner() = default;
Thinner::Thinner(Thinner&&) noexcept = default;
Thinner& Thinner::operator=(Thinner&&) noexcept = default;

int Thinner::operator()(ConstImageView source, ImageView destination) {
  detail::check_views(source, destination, detail::InPlace::allowed);
  if (source.width != width_ || source.height != height_) {
    throw std::invalid_argument("expected images of " + detail::size_text(width_, height_) +
                                ", got " + detail::size_text(source.width, source.height));
  }
  if (width_ == 0 || height_ == 0) return 1;
  return state_->run(source, destination);
}

int thin(Rule rule, ConstImageView source, ImageView destination, const Options& options) {
  detail::check_views(source, destination, detail::InPlace::allowed);
  return Thinner(rule, source.width, source.height, options)(source, destination);
}

}  // namespace thinbench
