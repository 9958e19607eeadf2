#include "thinbench_edges.hpp"

#include <stdexcept>
#include <string>

#include "image/check_views.hpp"

namespace thinbench {

const EdgeVariant& choose_variant(const EdgeOperation& operation, Index width,
                                  const VariantRequest& wish) {
  std::vector<VariantFacts> facts;
  for (const EdgeVariant& variant : operation.variants) facts.push_back(variant.facts);
  return operation.variants[choose_variant(operation.name, facts, width, wish)];
}

void detect_edges(std::string_view operation, ConstImageView source, ImageView destination,
                  const EdgeThresholds& thresholds, const VariantRequest& wish) {
  check_views(source, destination, InPlace::refused);
  const EdgeOperation* found = find_edge_operation(operation);
  if (found == nullptr) {
    throw std::invalid_argument("no edge operation is named " + std::string(operation));
  }
  const EdgeVariant& variant = choose_variant(*found, source.width, wish);
  EdgePlan(*found, variant, source.width, source.height, {thresholds, wish.threads})
      .run(source, destination);
}

}  // namespace thinbench
