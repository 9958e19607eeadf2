#include "harness/localise_family.hpp"

#include <memory>

#include "api/catalogue.hpp"
#include "harness/regions_family.hpp"
#include "localise.hpp"

namespace thinbench {
namespace {

class RegionJob : public Job {
 public:
  [[nodiscard]] bool gives_image() const override { return false; }
  [[nodiscard]] std::string name_of_number(std::size_t index) const override {
    return name_of_region_number(index);
  }
};

class StateJob final : public RegionJob {
 public:
  explicit StateJob(std::unique_ptr<detail::LocaliseState> state) : state_(std::move(state)) {}

  void run(const ConstImageView& input, const ImageView& /*output*/) override {
    lists_ = state_->run(input);
  }
  [[nodiscard]] std::vector<std::int64_t> numbers() const override { return numbers_of(lists_); }

 private:
  std::unique_ptr<detail::LocaliseState> state_;
  detail::RegionLists lists_;
};

class ReferenceJob final : public RegionJob {
 public:
  void run(const ConstImageView& input, const ImageView& /*output*/) override {
    regions_ = reference::localise_objects(reference::edges(EdgeOperator::sobel), {}, input);
  }
  [[nodiscard]] std::vector<std::int64_t> numbers() const override {
    return numbers_of({regions_.objects, regions_.holes});
  }

 private:
  reference::Regions regions_;
};

Variant variant_of(const detail::LocaliseOperation& operation,
                   const detail::LocaliseVariant& variant) {
  const TechniqueInfo& info = technique_info(variant.technique);
  return {info.name,
          info.description,
          variant.isa,
          variant.threaded,
          false,
          [&operation, &variant](Index width, Index height, int threads) -> std::unique_ptr<Job> {
            return std::make_unique<StateJob>(
                make_state(operation, variant, width, height, {}, {.threads = threads}));
          },
          [&variant](Index width) { return unavailable_reason(variant, width); },
          variant.priority};
}

}  // namespace

std::vector<Operation> localise_family() {
  const detail::LocaliseOperation& chain = detail::localise_operation();
  Operation result = {std::string(chain.name), chain.description, InputKind::grey, {}, {}};
  for (const detail::LocaliseVariant& variant : chain.variants) {
    result.variants.push_back(variant_of(chain, variant));
  }
  result.reference = [](Index, Index, int) { return std::make_unique<ReferenceJob>(); };
  result.operation = chain.name;
  return {result};
}

}  // namespace thinbench
