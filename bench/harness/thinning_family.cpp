#include "harness/thinning_family.hpp"

#include <stdexcept>
#include <utility>

#include "catalog.hpp"
#include "reference.hpp"

namespace thinbench {
namespace {

/// What all thinning gives beside the image.
class CountingJob : public Job {
 public:
  [[nodiscard]] std::vector<std::int64_t> numbers() const override { return {passes_}; }
  [[nodiscard]] std::string name_of_number(std::size_t) const override { return "passes"; }

 protected:
  int passes_ = 0;
};

class PlanJob final : public CountingJob {
 public:
  explicit PlanJob(ThinningPlan plan) : plan_(std::move(plan)) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    passes_ = plan_.run(input, output);
  }
  void load(const ConstImageView& input) override { plan_.load(input); }
  void kernel() override { passes_ = plan_.thin(); }
  void store(const ImageView& output) const override { plan_.store(output); }
  [[nodiscard]] bool margins_are_intact() const override { return plan_.margins_are_zero(); }

 private:
  ThinningPlan plan_;
};

class ReferenceJob final : public CountingJob {
 public:
  explicit ReferenceJob(reference::Thinning function) : function_(function) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    passes_ = function_(input, output);
  }

 private:
  reference::Thinning function_;
};

std::unique_ptr<Job> reference_job(std::string_view operation) {
  const reference::Thinning function = reference::find_thinning(operation);
  if (function == nullptr) throw std::logic_error(std::string(operation) + " has no reference");
  return std::make_unique<ReferenceJob>(function);
}

Variant variant_of(const ThinningOperation& operation, const ThinningVariant& variant) {
  const TechniqueInfo& info = technique_info(variant.technique);
  return {info.name,
          info.description,
          variant.isa,
          variant.threaded,
          true,
          [&operation, &variant](Index width, Index height, int threads) {
            return thinning_job({operation, variant, width, height, PlanOptions{threads}});
          },
          [&variant](Index width) { return unavailable_reason(variant, width); }};
}

}  // namespace

std::unique_ptr<Job> thinning_job(ThinningPlan plan) {
  return std::make_unique<PlanJob>(std::move(plan));
}

Operation thinning_operation(const ThinningOperation& operation) {
  Operation result = {
      std::string(operation.name), operation.description, InputKind::binary, {}, {}};
  for (const ThinningVariant& variant : operation.variants) {
    result.variants.push_back(variant_of(operation, variant));
  }
  result.reference = [name = operation.name](Index, Index, int) { return reference_job(name); };
  result.counter = "passes";
  result.is_net = operation.default_model != nullptr;
  result.in_size_series = operation.name == "thin_naccache_shinghal";
  result.small_sets_only = result.is_net && operation.max_iterations > 1;
  return result;
}

std::vector<Operation> thinning_family() {
  std::vector<Operation> family;
  for (const ThinningOperation& operation : thinning_operations()) {
    family.push_back(thinning_operation(operation));
  }
  return family;
}

}  // namespace thinbench
