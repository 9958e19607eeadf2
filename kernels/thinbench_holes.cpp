#include "thinbench_holes.hpp"

#include "image/check_views.hpp"

namespace thinbench {
namespace {

HolesPlan make_plan(std::string_view name, const ConstImageView& source, const VariantRequest& wish) {
  check_views(source, source, InPlace::allowed);
  const HolesOperation& operation = *find_holes_operation(name);
  const HolesVariant& variant = choose_variant(operation, source.width, wish);
  return {operation, variant, source.width, source.height, wish.threads};
}

std::int64_t number_of(std::string_view name, const ConstImageView& source,
                       const VariantRequest& wish) {
  HolesPlan plan = make_plan(name, source, wish);
  plan.run(source);
  return plan.number();
}

}  // namespace

const HolesVariant& choose_variant(const HolesOperation& operation, Index width,
                                   const VariantRequest& wish) {
  std::vector<VariantFacts> facts;
  for (const HolesVariant& one : operation.variants) facts.push_back(facts_of(one));
  return operation.variants[choose_variant(operation.name, facts, width, wish)];
}

FoundHoles find_holes(ConstImageView source, const VariantRequest& wish) {
  HolesPlan plan = make_plan("holes", source, wish);
  plan.run(source);
  const RegionLists lists = plan.regions();
  return {{lists.objects.begin(), lists.objects.end()}, {lists.holes.begin(), lists.holes.end()}};
}

std::vector<Region> find_components(ConstImageView source, const VariantRequest& wish) {
  HolesPlan plan = make_plan("components", source, wish);
  plan.run(source);
  const RegionLists lists = plan.regions();
  return {lists.objects.begin(), lists.objects.end()};
}

std::int64_t euler_number(ConstImageView source, const VariantRequest& wish) {
  return number_of("euler_number", source, wish);
}

std::int64_t euler_number_4(ConstImageView source, const VariantRequest& wish) {
  return number_of("euler_number_4", source, wish);
}

void fill_holes(ConstImageView source, ImageView destination, const VariantRequest& wish) {
  check_views(source, destination, InPlace::allowed);
  HolesPlan plan = make_plan("fill_holes", source, wish);
  plan.run(source);
  plan.store(destination);
}

}  // namespace thinbench
