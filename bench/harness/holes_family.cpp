#include "harness/holes_family.hpp"

#include <array>
#include <memory>

#include "catalog.hpp"
#include "holes.hpp"
#include "regions/plan.hpp"

namespace thinbench {
namespace {

constexpr std::size_t kCounts = 2;
constexpr std::array kMembers = {"area", "sum of x", "sum of y", "left",
                                 "top",  "right",    "bottom",   "owner"};

void append(std::vector<std::int64_t>& numbers, const Region& region) {
  numbers.insert(numbers.end(), {region.area, region.sum_x, region.sum_y, region.left, region.top,
                                 region.right, region.bottom, region.owner});
}

/// Jobs of one task; what they give follows from it.
class TaskJob : public Job {
 public:
  explicit TaskJob(HolesTask task) : task_(task) {}

  [[nodiscard]] bool gives_image() const override { return task_ == HolesTask::fill; }

  [[nodiscard]] std::string name_of_number(std::size_t index) const override {
    if (task_ != HolesTask::holes && task_ != HolesTask::components) return "Euler number";
    return name_of_region_number(index);
  }

 protected:
  [[nodiscard]] HolesTask task() const { return task_; }

 private:
  HolesTask task_;
};

class PlanJob final : public TaskJob {
 public:
  PlanJob(const HolesOperation& operation, const HolesVariant& variant, Index width, Index height,
          int threads)
      : TaskJob(operation.task), plan_(operation, variant, width, height, threads) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    plan_.run(input);
    if (gives_image()) plan_.store(output);
  }
  void load(const ConstImageView& input) override { plan_.load(input); }
  void kernel() override { plan_.compute(); }
  void store(const ImageView& output) const override { plan_.store(output); }

  [[nodiscard]] std::vector<std::int64_t> numbers() const override {
    switch (task()) {
      case HolesTask::holes:
      case HolesTask::components:
        return numbers_of(plan_.regions());
      case HolesTask::euler_eight:
      case HolesTask::euler_four:
        return {plan_.number()};
      case HolesTask::fill:
        return {};
    }
    return {};
  }
  [[nodiscard]] bool margins_are_intact() const override { return plan_.margins_are_zero(); }

 private:
  HolesPlan plan_;
};

class ReferenceJob final : public TaskJob {
 public:
  using TaskJob::TaskJob;

  void run(const ConstImageView& input, const ImageView& output) override {
    switch (task()) {
      case HolesTask::holes:
        regions_ = reference::holes(input);
        break;
      case HolesTask::components:
        regions_ = reference::components(input);
        break;
      case HolesTask::euler_eight:
        number_ = reference::euler_number(input);
        break;
      case HolesTask::euler_four:
        number_ = reference::euler_number_4(input);
        break;
      case HolesTask::fill:
        reference::fill_holes(input, output);
        break;
    }
  }

  [[nodiscard]] std::vector<std::int64_t> numbers() const override {
    if (gives_image()) return {};
    const bool gives_lists = task() == HolesTask::holes || task() == HolesTask::components;
    if (!gives_lists) return {number_};
    return numbers_of({regions_.objects, regions_.holes});
  }

 private:
  reference::Regions regions_;
  std::int64_t number_ = 0;
};

Variant variant_of(const HolesOperation& operation, const HolesVariant& variant) {
  const TechniqueInfo& info = technique_info(variant.technique);
  return {info.name,
          info.description,
          variant.isa,
          variant.threaded,
          true,
          [&operation, &variant](Index width, Index height, int threads) -> std::unique_ptr<Job> {
            return std::make_unique<PlanJob>(operation, variant, width, height, threads);
          },
          [&variant](Index width) { return unavailable_reason(facts_of(variant), width); }};
}

Operation operation_of_table(const HolesOperation& operation) {
  Operation result = {
      std::string(operation.name), operation.description, InputKind::binary, {}, {}};
  for (const HolesVariant& variant : operation.variants) {
    result.variants.push_back(variant_of(operation, variant));
  }
  result.in_size_series = operation.name == "holes";
  result.reference = [task = operation.task](Index, Index, int) {
    return std::make_unique<ReferenceJob>(task);
  };
  return result;
}

}  // namespace

std::vector<std::int64_t> numbers_of(const RegionLists& lists) {
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

std::vector<Operation> holes_family() {
  std::vector<Operation> family;
  for (const HolesOperation& operation : holes_operations()) {
    family.push_back(operation_of_table(operation));
  }
  return family;
}

}  // namespace thinbench
