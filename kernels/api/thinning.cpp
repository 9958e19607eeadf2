#include "thinbench/thinning.hpp"

#include "core/checks.hpp"
#include "thinbench/packed.hpp"
#include "thinning/operations.hpp"

namespace thinbench {
namespace {

using detail::ThinningState;
using detail::ThinningVariant;

struct Chosen {
  const ThinningVariant& variant;
  std::unique_ptr<ThinningState> state;
};

Chosen choose(const Rule& rule, Index width, Index height, const Thinning& thinning,
              const Execution& execution) {
  const detail::ThinningParameters parameters = detail::thinning_parameters(rule, thinning);
  const ThinningVariant& variant = detail::choose_thinning(parameters, width, height, execution);
  return {variant, detail::make_state(variant, width, height, parameters, execution.threads)};
}

void require_order(BitOrder order, const char* name) {
  detail::require(order == BitOrder::msb_first || order == BitOrder::lsb_first, [&] {
    return name + (" has the bit order " + std::to_string(static_cast<int>(order))) +
           "; expected msb_first or lsb_first";
  });
}

}  // namespace

Thinner::Thinner(const Rule& rule, Index width, Index height, const Thinning& thinning,
                 const Execution& execution)
    : width_(width), height_(height) {
  Chosen chosen = choose(rule, width, height, thinning, execution);
  state_ = std::move(chosen.state);
  technique_ = chosen.variant.technique;
  isa_ = chosen.variant.isa;
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
  return state_->run(source, destination);
}

int thin(const Rule& rule, ConstImageView source, ImageView destination, const Thinning& thinning,
         const Execution& execution) {
  detail::check_views(source, destination, detail::InPlace::allowed);
  return choose(rule, source.width, source.height, thinning, execution)
      .state->run(source, destination);
}

int thin(const Rule& rule, ConstPackedView source, PackedView destination, const Thinning& thinning,
         const Execution& execution) {
  require_order(source.order, "source");
  require_order(destination.order, "destination");
  detail::check_views(source, destination, detail::InPlace::allowed);
  return choose(rule, source.width, source.height, thinning, execution)
      .state->run(source, destination);
}

}  // namespace thinbench
