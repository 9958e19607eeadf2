#include <array>
#include <memory>

#include "harness/families.hpp"
#include "holes.hpp"
#include "localise.hpp"
#include "techniques/variants.hpp"

namespace thinbench {
namespace {

using detail::RegionsOperation;
using detail::RegionsState;
using detail::RegionsTask;
using detail::RegionsVariant;

constexpr std::size_t kCounts = 2;
constexpr std::array kMembers = {"area", "sum of x", "sum of y", "left",
                                 "top",  "right",    "bottom",   "enclosing object"};

void append(std::vector<std::int64_t>& numbers, const Region& region) {
  numbers.insert(numbers.end(), {region.area, region.sum_x, region.sum_y, region.left, region.top,
                                 region.right, region.bottom, region.enclosing_object});
}

/// Jobs of one task; what they give follows from it.
class TaskJob : public Job {
 public:
  explicit TaskJob(RegionsTask task) : task_(task) {}

  [[nodiscard]] bool gives_image() const override {
    return task_ == RegionsTask::fill || task_ == RegionsTask::fill_four;
  }

  [[nodiscard]] std::string name_of_number(std::size_t index) const override {
    if (task_ != RegionsTask::holes && task_ != RegionsTask::components) return "Euler number";
    return name_of_region_number(index);
  }

 protected:
  [[nodiscard]] RegionsTask task() const { return task_; }

 private:
  RegionsTask task_;
};

class StateJob final : public TaskJob {
 public:
  StateJob(RegionsTask task, std::unique_ptr<RegionsState> state)
      : TaskJob(task), state_(std::move(state)) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    state_->load(input);
    state_->compute();
    if (gives_image()) state_->store(output);
  }
  void load(const ConstImageView& input) override { state_->load(input); }
  void kernel() override { state_->compute(); }
  void store(const ImageView& output) const override { state_->store(output); }

  [[nodiscard]] std::vector<std::int64_t> numbers() const override {
    switch (task()) {
      case RegionsTask::holes:
      case RegionsTask::components:
        return numbers_of(state_->regions());
      case RegionsTask::euler_eight:
      case RegionsTask::euler_four:
        return {state_->number()};
      case RegionsTask::fill:
      case RegionsTask::fill_four:
        return {};
    }
    return {};
  }

 private:
  std::unique_ptr<RegionsState> state_;
};

class ReferenceJob final : public TaskJob {
 public:
  using TaskJob::TaskJob;

  void run(const ConstImageView& input, const ImageView& output) override {
    switch (task()) {
      case RegionsTask::holes:
        regions_ = reference::holes(input);
        break;
      case RegionsTask::components:
        regions_ = reference::components(input);
        break;
      case RegionsTask::euler_eight:
        number_ = reference::euler_number(input);
        break;
      case RegionsTask::euler_four:
        number_ = reference::euler_number_4(input);
        break;
      case RegionsTask::fill:
        reference::fill_holes(input, output);
        break;
      case RegionsTask::fill_four:
        reference::fill_holes_4(input, output);
        break;
    }
  }

  [[nodiscard]] std::vector<std::int64_t> numbers() const override {
    if (gives_image()) return {};
    const bool gives_lists = task() == RegionsTask::holes || task() == RegionsTask::components;
    if (!gives_lists) return {number_};
    return numbers_of({regions_.objects, regions_.holes});
  }

 private:
  reference::Regions regions_;
  std::int64_t number_ = 0;
};

/// Gives lists of regions as numbers.
class ListJob : public Job {
 public:
  [[nodiscard]] bool gives_image() const override { return false; }
  [[nodiscard]] std::string name_of_number(std::size_t index) const override {
    return name_of_region_number(index);
  }
};

class ChainJob final : public ListJob {
 public:
  explicit ChainJob(std::unique_ptr<detail::LocaliseState> state) : state_(std::move(state)) {}

  void run(const ConstImageView& input, const ImageView& /*output*/) override {
    lists_ = state_->run(input);
  }
  [[nodiscard]] std::vector<std::int64_t> numbers() const override { return numbers_of(lists_); }

 private:
  std::unique_ptr<detail::LocaliseState> state_;
  detail::RegionLists lists_;
};

class ChainReference final : public ListJob {
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

Operation operation_of_table(const RegionsOperation& operation) {
  Operation result = {
      std::string(operation.name), operation.description, InputKind::binary, {}, {}};
  for (const RegionsVariant& variant : operation.variants) {
    result.variants.push_back(library_variant(
        variant, true, [task = operation.key, &variant](Index width, Index height, int threads) {
          return std::make_unique<StateJob>(
              task, detail::make_state(variant, width, height, {task}, threads));
        }));
  }
  result.operation = operation.name;
  result.reference = [task = operation.key](Index, Index, int) {
    return std::make_unique<ReferenceJob>(task);
  };
  return result;
}

}  // namespace

std::vector<std::int64_t> numbers_of(const detail::RegionLists& lists) {
  std::vector<std::int64_t> numbers = {static_cast<std::int64_t>(lists.objects.size()),
                                       static_cast<std::int64_t>(lists.holes.size())};
  for (const Region& object : lists.objects) append(numbers, object);
  for (const Region& hole : lists.holes) append(numbers, hole);
  return numbers;
}

std::string name_of_region_number(std::size_t index) {
  if (index < kCounts) return index == 0 ? "objects" : "holes";
  const std::size_t region = (index - kCounts) / kMembers.size();
  return std::string(kMembers.at((index - kCounts) % kMembers.size())) + " of region " +
         std::to_string(region + 1) + " of both lists";
}

std::vector<Operation> regions_family() {
  std::vector<Operation> family;
  for (const RegionsOperation& operation : detail::study::regions_operations()) {
    family.push_back(operation_of_table(operation));
  }
  return family;
}

std::vector<Operation> localise_family() {
  const detail::LocaliseOperation& chain = detail::localise_operation();
  Operation result = {std::string(chain.name), chain.description, InputKind::grey, {}, {}};
  for (const detail::LocaliseVariant& variant : chain.variants) {
    result.variants.push_back(
        library_variant(variant, false, [&variant](Index width, Index height, int threads) {
          return std::make_unique<ChainJob>(
              detail::make_state(variant, width, height, {EdgeOperator::sobel, {}}, threads));
        }));
  }
  result.reference = [](Index, Index, int) { return std::make_unique<ChainReference>(); };
  result.operation = chain.name;
  return {result};
}

}  // namespace thinbench
