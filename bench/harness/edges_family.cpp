#include <utility>

#include "harness/families.hpp"
#include "reference.hpp"

namespace thinbench {
namespace {

class StateJob final : public Job {
 public:
  explicit StateJob(std::unique_ptr<detail::EdgeState> state) : state_(std::move(state)) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    state_->run(input, output);
  }

 private:
  std::unique_ptr<detail::EdgeState> state_;
};

class ReferenceJob final : public Job {
 public:
  ReferenceJob(reference::EdgeDetection function, const EdgeThresholds& thresholds)
      : function_(function), thresholds_(thresholds) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    function_(thresholds_, input, output);
  }

 private:
  reference::EdgeDetection function_;
  EdgeThresholds thresholds_;
};

}  // namespace

JobMaker edges_reference(EdgeOperator op, const EdgeThresholds& thresholds) {
  return [function = reference::edges(op), thresholds](Index, Index, int) {
    return std::make_unique<ReferenceJob>(function, thresholds);
  };
}

Operation edges_operation(const detail::EdgeOperation& operation,
                          const EdgeThresholds& thresholds) {
  Operation result = {std::string(operation.name), operation.description, InputKind::grey, {}, {}};
  for (const detail::EdgeVariant& variant : operation.variants) {
    result.variants.push_back(library_variant(
        variant, false,
        [op = operation.key, &variant, thresholds](Index width, Index height, int threads) {
          return std::make_unique<StateJob>(
              detail::make_state(variant, width, height, {op, thresholds}, threads));
        }));
  }
  result.reference = edges_reference(operation.key, thresholds);
  result.operation = operation.name;
  return result;
}

std::vector<Operation> edges_family() {
  std::vector<Operation> family;
  for (const detail::EdgeOperation& operation : detail::study::edge_operations()) {
    family.push_back(edges_operation(operation, {}));
  }
  return family;
}

}  // namespace thinbench
