// Variants by the names of their techniques, those of the study included, and their states.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/variants.hpp"

namespace thinbench {

/// "lut at baseline with threads"
inline std::string name_of(const detail::VariantInfo& variant) {
  return std::string(variant.technique) + " at " + std::string(isa_name(variant.isa)) +
         (variant.threaded ? " with threads" : "");
}

/// The variant of this technique, of the requested ISA or of the last that is available.
template <class Variant>
[[nodiscard]] Variant variant_of(const std::vector<Variant>& variants, std::string_view technique,
                                 const Execution& execution = {}) {
  const auto found = std::find_if(variants.rbegin(), variants.rend(), [&](const Variant& one) {
    return one.technique == technique && one.threaded == (execution.threads > 1) &&
           one.isa == execution.isa.value_or(one.isa) && isa_available(one.isa);
  });
  if (found == variants.rend()) throw std::logic_error("no variant " + std::string(technique));
  return *found;
}

/// All variants; of a complement the product's alone.
[[nodiscard]] inline std::vector<detail::ThinningVariant> variants_of(
    const detail::ThinningParameters& parameters) {
  if (parameters.complemented) return detail::thinning_variants(*parameters.rule);
  return detail::study::all_variants(*parameters.rule);
}

/// The variant that thin() takes.
[[nodiscard]] inline const detail::ThinningVariant& chosen_variant(
    const Rule& rule, Index width, Index height, const Execution& execution = {}) {
  return detail::choose_variant(detail::thinning_variants(*detail::body_of(rule)), width, height,
                                execution);
}

/// Thins by one technique.
inline int thin_by(std::string_view technique, const Rule& rule, const ConstImageView& source,
                   const ImageView& destination, const Thinning& thinning = {},
                   const Execution& execution = {}) {
  const detail::ThinningParameters parameters = detail::thinning_parameters(rule, thinning);
  const auto variant = variant_of(variants_of(parameters), technique, execution);
  return make_state(variant, source.width, source.height, parameters, execution.threads)
      ->run(source, destination);
}

/// Calls `check(state, name)` for a new state of each variant that can run here. Threaded ones have
/// `threads` threads.
template <class Check>
void for_each_state(const detail::ThinningParameters& parameters, Index width, Index height,
                    int threads, const Check& check) {
  for (const detail::ThinningVariant& variant : variants_of(parameters)) {
    if (!unavailable_reason(variant, width).empty()) continue;
    check(*make_state(variant, width, height, parameters, threads), name_of(variant));
  }
}

}  // namespace thinbench
