#include <stdexcept>

#include "harness/library_operation.hpp"
#include "regions/state.hpp"

namespace thinbench {
namespace {

using detail::LabelTask;

/// Labels, then the lists.
struct Labels {
  static constexpr bool kGivesImage = false;
  Labels(Index width, Index height) : pixels("label", width, height) {}

  [[nodiscard]] std::vector<std::int64_t> numbers() const {
    std::vector<std::int64_t> numbers = pixels.numbers();
    for (const std::int64_t number : numbers_of(lists)) numbers.push_back(number);
    return numbers;
  }
  [[nodiscard]] std::string name_of_number(std::size_t index) const {
    return index < pixels.size() ? pixels.name_of_number(index)
                                 : name_of_region_number(index - pixels.size());
  }

  PixelNumbers pixels;
  Regions lists;
};

reference::Regions labelled(LabelTask task, const ConstImageView& input, const LabelView& labels) {
  switch (task) {
    case LabelTask::regions:
      return reference::label_regions(input, labels);
    case LabelTask::objects_eight:
      return {reference::label_objects(input, labels), {}};
    case LabelTask::objects_four:
      return {reference::label_objects_4(input, labels), {}};
    case LabelTask::image_eight:
      reference::label_objects(input, labels);
      return {};
    case LabelTask::image_four:
      reference::label_objects_4(input, labels);
      return {};
  }
  throw std::logic_error("a task of labels has no reference");
}

}  // namespace

std::vector<Operation> labels_family() {
  std::vector<Operation> family;
  for (const detail::LabelOperation& operation : detail::label_operations()) {
    family.push_back(library_operation<Labels>(
        operation, {operation.key}, InputKind::binary,
        [](detail::LabelState& state, const auto& input, const auto&, auto& found) {
          state.run(input, found.pixels.view(), found.lists);
        },
        job_maker<Labels>([task = operation.key](const auto& input, const auto&, auto& found) {
          found.lists = lists_of(labelled(task, input, found.pixels.view()));
        })));
  }
  return family;
}

}  // namespace thinbench
