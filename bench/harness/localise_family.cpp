#include "harness/localise_family.hpp"

#include <memory>

#include "catalog.hpp"
#include "harness/holes_family.hpp"
#include "localise.hpp"
#include "localise/plan.hpp"

namespace thinbench {
namespace {

class RegionJob : public Job {
 public:
  [[nodiscard]] bool gives_image() const override { return false; }
  [[nodiscard]] std::string name_of_number(std::size_t index) const override {
    return name_of_region_number(index);
  }
};

class PlanJob final : public RegionJob {
 public:
  PlanJob(const LocaliseVariant& variant, Index width, Index height, int threads)
      : plan_(variant, width, height, {EdgeOperator::sobel, {}, threads}) {}

  void run(const ConstImageView& input, const ImageView& /*output*/) override {
    lists_ = plan_.run(input);
  }
  [[nodiscard]] std::vector<std::int64_t> numbers() const override { return numbers_of(lists_); }
  [[nodiscard]] bool margins_are_intact() const override { return plan_.margins_are_zero(); }

 private:
  LocalisePlan plan_;
  RegionLists lists_;
};

class ReferenceJob final : public RegionJob {
 public:
  void run(const ConstImageView& input, const ImageView& /*output*/) override {
    const EdgeThresholds thresholds;
    regions_ = reference::localise_objects(reference::find_edges("edges_sobel"), thresholds.p1,
                                           thresholds.p2, input);
  }
  [[nodiscard]] std::vector<std::int64_t> numbers() const override {
    return numbers_of({regions_.objects, regions_.holes});
  }

 private:
  reference::Regions regions_;
};

Variant variant_of(const LocaliseVariant& variant) {
  const TechniqueInfo& info = technique_info(variant.facts.technique);
  return {info.name,
          info.description,
          variant.facts.isa,
          variant.facts.threaded,
          false,
          [&variant](Index width, Index height, int threads) -> std::unique_ptr<Job> {
            return std::make_unique<PlanJob>(variant, width, height, threads);
          },
          [&variant](Index width) { return unavailable_reason(variant.facts, width); }};
}

}  // namespace

std::vector<Operation> localise_family() {
  const LocaliseOperation& chain = localise_operation();
  Operation result = {std::string(chain.name), chain.description, InputKind::grey, {}, {}};
  for (const LocaliseVariant& variant : chain.variants) {
    result.variants.push_back(variant_of(variant));
  }
  result.reference = [](Index, Index, int) { return std::make_unique<ReferenceJob>(); };
  result.in_size_series = true;
  return {result};
}

}  // namespace thinbench
