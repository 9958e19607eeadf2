#include "thinbench_localise.hpp"

#include "image/check_views.hpp"
#include "localise/plan.hpp"

namespace thinbench {

const LocaliseVariant& choose_variant(const LocaliseOperation& operation, Index width,
                                      const VariantRequest& wish) {
  std::vector<VariantFacts> facts;
  for (const LocaliseVariant& variant : operation.variants) facts.push_back(variant.facts);
  return operation.variants[choose_variant(operation.name, facts, width, wish)];
}

FoundHoles localise_objects(ConstImageView grey, const EdgeThresholds& thresholds,
                            const VariantRequest& wish) {
  check_views(grey, grey, InPlace::allowed);
  const LocaliseVariant& variant = choose_variant(localise_operation(), grey.width, wish);
  LocalisePlan plan(variant, grey.width, grey.height,
                    {EdgeOperator::sobel, thresholds, wish.threads});
  const RegionLists lists = plan.run(grey);
  return {{lists.objects.begin(), lists.objects.end()}, {lists.holes.begin(), lists.holes.end()}};
}

}  // namespace thinbench
