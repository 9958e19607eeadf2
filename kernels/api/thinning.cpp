#include "thinbench/thinning.hpp"

#include "core/checks.hpp"
#include "thinbench/packed.hpp"
#include "thinning/operations.hpp"

namespace thinbench {
namespace {

void require_order(BitOrder order, const char* name) {
  detail::require(order == BitOrder::msb_first || order == BitOrder::lsb_first, [&] {
    return name + (" has the bit order " + std::to_string(static_cast<int>(order))) +
           "; expected msb_first or lsb_first";
  });
}

}  // namespace

Thinner::Thinner(const Rule& rule, Index width, Index height, const Thinning& thinning,
                 const Execution& execution)
    : state_(detail::make_thinning({rule, thinning, execution}, width, height)),
      width_(width),
      height_(height) {}

Thinner::~Thinner() = default;
Thinner::Thinner(Thinner&&) noexcept = default;
Thinner& Thinner::operator=(Thinner&&) noexcept = default;

int Thinner::operator()(ConstImageView source, ImageView destination) {
  detail::check_views(source, destination, detail::InPlace::allowed);
  if (source.width != width_ || source.height != height_) {
    throw std::invalid_argument("expected images of " + detail::size_text(width_, height_) +
                                ", got " + detail::size_text(source.width, source.height));
  }
  return state_->run(source, destination);
}

int thin(const Rule& rule, ConstImageView source, ImageView destination, const Thinning& thinning,
         const Execution& execution) {
  detail::check_views(source, destination, detail::InPlace::allowed);
  return detail::make_thinning({rule, thinning, execution}, source.width, source.height)
      ->run(source, destination);
}

int thin_packed(const Rule& rule, ConstPackedView source, PackedView destination,
                const Thinning& thinning, const Execution& execution) {
  require_order(source.order, "source");
  require_order(destination.order, "destination");
  detail::check_views(source, destination, detail::InPlace::allowed);
  return detail::make_thinning({rule, thinning, execution}, source.width, source.height)
      ->run(source, destination);
}

}  // namespace thinbench
