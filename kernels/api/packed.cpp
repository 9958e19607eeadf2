#include "thinbench/packed.hpp"

#include "api/catalogue.hpp"
#include "image/checks.hpp"

namespace thinbench {

int thin(Rule rule, ConstPackedView source, PackedView destination, const Options& options) {
  detail::check_views(source, destination);
  const detail::ThinningOperation& operation = detail::operation_of(rule);
  const detail::ThinningVariant& variant =
      detail::choose(operation, source.width, source.height, options);
  return detail::make_state(operation, variant, source.width, source.height, options)
      ->run(source, destination);
}

int apply(const CustomRule& rule, ConstPackedView source, PackedView destination,
          const Options& options) {
  detail::check_views(source, destination);
  const detail::ThinningVariant& variant =
      detail::choose_custom(rule, source.width, source.height, options);
  return detail::make_custom_state(rule, variant, source.width, source.height, options)
      ->run(source, destination);
}

}  // namespace thinbench
