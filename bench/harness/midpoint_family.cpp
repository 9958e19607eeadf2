#include <utility>

#include "harness/families.hpp"
#include "reference.hpp"

namespace thinbench {
namespace {

class StateJob final : public Job {
 public:
  explicit StateJob(std::unique_ptr<detail::MidpointState> state) : state_(std::move(state)) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    state_->run(input, output);
  }

 private:
  std::unique_ptr<detail::MidpointState> state_;
};

class ReferenceJob final : public Job {
 public:
  explicit ReferenceJob(Border border) : border_(border) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    reference::midpoint_scan({}, border_, input, output);
  }

 private:
  Border border_;
};

Operation midpoint_operation(Border border) {
  const detail::MidpointOperation& operation = detail::study::midpoint_operation();
  std::string name(operation.name);
  if (border == Border::keep) name += ":keep";
  Operation result = {std::move(name), operation.description, InputKind::binary, {}, {}};
  for (const auto& variant : operation.variants) {
    result.variants.push_back(
        library_variant(variant, false, [&variant, border](Index width, Index height, int threads) {
          return std::make_unique<StateJob>(
              detail::make_state(variant, width, height, {{}, border}, threads));
        }));
  }
  result.reference = [border](Index, Index, int) { return std::make_unique<ReferenceJob>(border); };
  result.operation = operation.name;
  result.border = border;
  result.timed = border == Border::background;
  return result;
}

}  // namespace

std::vector<Operation> midpoint_family() {
  return {midpoint_operation(Border::background), midpoint_operation(Border::keep)};
}

}  // namespace thinbench
