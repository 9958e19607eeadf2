#include <utility>
#include <vector>

#include "harness/families.hpp"
#include "holes.hpp"
#include "regions/state.hpp"

namespace thinbench {
namespace {

using detail::LabelState;
using detail::LabelTask;

/// Labels as numbers, row by row, then the lists.
class LabelsJob : public Job {
 public:
  LabelsJob(Index width, Index height)
      : width_(width), height_(height), labels_(static_cast<std::size_t>(width * height)) {}

  [[nodiscard]] bool gives_image() const override { return false; }
  [[nodiscard]] std::vector<std::int64_t> numbers() const override {
    std::vector<std::int64_t> numbers(labels_.begin(), labels_.end());
    for (const std::int64_t number : numbers_of(lists_)) numbers.push_back(number);
    return numbers;
  }
  [[nodiscard]] std::string name_of_number(std::size_t index) const override {
    if (index >= labels_.size()) return name_of_region_number(index - labels_.size());
    const auto pixel = static_cast<Index>(index);
    return "label at (" + std::to_string(pixel % width_) + ", " + std::to_string(pixel / width_) +
           ")";
  }

 protected:
  [[nodiscard]] LabelView labels() { return {labels_.data(), width_, height_}; }
  Regions lists_;

 private:
  Index width_;
  Index height_;
  std::vector<std::int32_t> labels_;
};

class StateJob final : public LabelsJob {
 public:
  StateJob(Index width, Index height, std::unique_ptr<LabelState> state)
      : LabelsJob(width, height), state_(std::move(state)) {}

  void run(const ConstImageView& input, const ImageView& /*output*/) override {
    state_->run(input, labels(), lists_);
  }

 private:
  std::unique_ptr<LabelState> state_;
};

reference::Regions labelled(LabelTask task, const ConstImageView& input, const LabelView& labels) {
  switch (task) {
    case LabelTask::regions:
      return reference::label_regions(input, labels);
    case LabelTask::objects_eight:
      return {reference::label_components(input, labels), {}};
    case LabelTask::objects_four:
      return {reference::label_components_4(input, labels), {}};
    case LabelTask::image_eight:
      reference::label_components(input, labels);
      return {};
    case LabelTask::image_four:
      reference::label_components_4(input, labels);
      return {};
  }
  return {};
}

class ReferenceJob final : public LabelsJob {
 public:
  ReferenceJob(LabelTask task, Index width, Index height) : LabelsJob(width, height), task_(task) {}

  void run(const ConstImageView& input, const ImageView& /*output*/) override {
    auto [objects, holes] = labelled(task_, input, labels());
    lists_ = {std::move(objects), std::move(holes)};
  }

 private:
  LabelTask task_;
};

Operation operation_of_table(const detail::LabelOperation& operation) {
  Operation result = {
      std::string(operation.name), operation.description, InputKind::binary, {}, {}};
  for (const auto& variant : operation.variants) {
    result.variants.push_back(library_variant(
        variant, false, [task = operation.key, &variant](Index width, Index height, int threads) {
          return std::make_unique<StateJob>(
              width, height, detail::make_state(variant, width, height, {task}, threads));
        }));
  }
  result.operation = operation.name;
  result.reference = [task = operation.key](Index width, Index height, int) {
    return std::make_unique<ReferenceJob>(task, width, height);
  };
  return result;
}

}  // namespace

std::vector<Operation> labels_family() {
  std::vector<Operation> family;
  for (const detail::LabelOperation& operation : detail::label_operations()) {
    family.push_back(operation_of_table(operation));
  }
  return family;
}

}  // namespace thinbench
