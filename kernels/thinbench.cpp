#include "thinbench.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "image/check_views.hpp"
#include "image/thread_team.hpp"
#include "dispatch/variant_choice.hpp"

namespace thinbench {

const ThinningVariant& choose_variant(const ThinningOperation& operation, Index width,
                                      const ThinningOptions& options) {
  const Border border = options.border.value_or(operation.border);
  const std::vector<const ThinningVariant*> candidates = variants_for_border(operation, border);
  std::vector<VariantFacts> facts;
  facts.reserve(candidates.size());
  for (const ThinningVariant* one : candidates) facts.push_back(facts_of(*one));
  return *candidates[choose_variant(operation.name, facts, width,
                                    {options.technique, options.isa, options.threads})];
}

int worthwhile_threads(const ThinningOperation& operation, const ThinningOptions& options,
                       Index width, Index height) {
  const bool is_small = height <= 0 || width < (kMinPixelsForThreads + height - 1) / height;
  const bool is_refused_later = options.threads < 1 || options.threads > kMaxThreads;
  const bool can_share = std::ranges::any_of(operation.variants, &ThinningVariant::threaded);
  const bool takes_all = options.technique || is_refused_later || (can_share && !is_small);
  return takes_all ? options.threads : 1;
}

int thin(std::string_view operation, ConstImageView source, ImageView destination,
         const ThinningOptions& options) {
  check_views(source, destination, InPlace::allowed);
  const ThinningOperation* found = find_thinning_operation(operation);
  if (found == nullptr) {
    throw std::invalid_argument("no operation is named " + std::string(operation));
  }
  ThinningOptions worthwhile = options;
  worthwhile.threads = worthwhile_threads(*found, options, source.width, source.height);
  const ThinningVariant& variant = choose_variant(*found, source.width, worthwhile);
  ThinningPlan plan(*found, variant, source.width, source.height,
                    {worthwhile.threads, options.model, options.border, options.directions});
  return plan.run(source, destination);
}

}  // namespace thinbench
