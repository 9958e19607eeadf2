#include "harness/edges_family.hpp"

#include <stdexcept>
#include <utility>

#include "catalog.hpp"
#include "reference.hpp"

namespace thinbench {
namespace {

class PlanJob final : public Job {
 public:
  explicit PlanJob(EdgePlan plan) : plan_(std::move(plan)) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    plan_.run(input, output);
  }
  void load(const ConstImageView& input) override { input_ = input; }
  void kernel() override { plan_.run_to_bits(input_); }
  void store(const ImageView& output) const override { plan_.store(output); }
  [[nodiscard]] bool margins_are_intact() const override { return plan_.margins_are_zero(); }

 private:
  EdgePlan plan_;
  ConstImageView input_;
};

class ReferenceJob final : public Job {
 public:
  ReferenceJob(reference::EdgeDetection function, const EdgeThresholds& thresholds)
      : function_(function), thresholds_(thresholds) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    function_(thresholds_.p1, thresholds_.p2, input, output);
  }

 private:
  reference::EdgeDetection function_;
  EdgeThresholds thresholds_;
};

Variant variant_of(const EdgeOperation& operation, const EdgeVariant& variant,
                   const EdgeThresholds& thresholds) {
  const TechniqueInfo& info = technique_info(variant.facts.technique);
  return {info.name,
          info.description,
          variant.facts.isa,
          variant.facts.threaded,
          variant.writes_bits(),
          [&operation, &variant, thresholds](Index width, Index height, int threads) {
            return std::make_unique<PlanJob>(
                EdgePlan(operation, variant, width, height, {thresholds, threads}));
          },
          [&variant](Index width) { return unavailable_reason(variant.facts, width); }};
}

}  // namespace

JobMaker edges_reference(std::string_view operation, const EdgeThresholds& thresholds) {
  const reference::EdgeDetection function = reference::find_edges(operation);
  if (function == nullptr) throw std::logic_error(std::string(operation) + " has no reference");
  return [function, thresholds](Index, Index, int) {
    return std::make_unique<ReferenceJob>(function, thresholds);
  };
}

Operation edges_operation(const EdgeOperation& operation, const EdgeThresholds& thresholds) {
  Operation result = {std::string(operation.name), operation.description, InputKind::grey, {}, {}};
  for (const EdgeVariant& variant : operation.variants) {
    result.variants.push_back(variant_of(operation, variant, thresholds));
  }
  result.reference = edges_reference(operation.name, thresholds);
  result.in_size_series = operation.name == "edges_sobel";
  return result;
}

std::vector<Operation> edges_family() {
  std::vector<Operation> family;
  for (const EdgeOperation& operation : edge_operations()) {
    family.push_back(edges_operation(operation, {}));
  }
  return family;
}

}  // namespace thinbench
