#include "thinbench/regions.hpp"

#include "core/checks.hpp"
#include "regions/labels_state.hpp"
#include "regions/state.hpp"

namespace thinbench {
namespace {

using detail::LabelsParameters;
using detail::LabelsState;
using detail::LabelsTask;
using detail::RegionsParameters;
using detail::RegionsState;
using detail::RegionsTask;

/// A state that holds the result.
std::unique_ptr<RegionsState> computed(const RegionsParameters& parameters,
                                       const ConstImageView& source, const Execution& execution) {
  detail::check_views(source, source, detail::InPlace::allowed);
  auto state = detail::make_best_state(detail::operation_of(parameters.task), source.width,
                                       source.height, parameters, execution);
  state->load(source);
  state->compute();
  return state;
}

/// Writes the labels; returns a state that holds the lists.
std::unique_ptr<LabelsState> labelled(const LabelsParameters& parameters,
                                      const ConstImageView& source, const LabelView& labels,
                                      const Execution& execution) {
  detail::require_label_size(source.width, source.height);
  detail::check(detail::memory_of("source", source), detail::memory_of("labels", labels),
                detail::InPlace::rejected);
  auto state = detail::make_best_state(detail::operation_of(parameters.task), source.width,
                                       source.height, parameters, execution);
  state->run(source, labels);
  return state;
}

std::vector<Region> copy_of(std::span<const Region> regions) {
  return {regions.begin(), regions.end()};
}

}  // namespace

Regions find_regions(ConstImageView source, const Execution& execution) {
  const auto state = computed({RegionsTask::holes}, source, execution);
  const detail::RegionLists lists = state->regions();
  return {copy_of(lists.objects), copy_of(lists.holes)};
}

std::vector<Region> find_components(ConstImageView source, const Execution& execution) {
  const auto state = computed({RegionsTask::components}, source, execution);
  return copy_of(state->regions().objects);
}

Regions label_regions(ConstImageView source, LabelView labels, const Execution& execution) {
  const auto state = labelled({LabelsTask::regions}, source, labels, execution);
  const detail::RegionLists lists = state->regions();
  return {copy_of(lists.objects), copy_of(lists.holes)};
}

std::vector<Region> label_components(ConstImageView source, LabelView labels,
                                     Connectivity connectivity, LabelOrder order,
                                     const Execution& execution) {
  const LabelsTask task = detail::labels_task(connectivity, true);
  return copy_of(labelled({task, order}, source, labels, execution)->regions().objects);
}

std::uint32_t label_image(ConstImageView source, LabelView labels, Connectivity connectivity,
                          LabelOrder order, const Execution& execution) {
  const LabelsTask task = detail::labels_task(connectivity, false);
  return labelled({task, order}, source, labels, execution)->objects();
}

std::int64_t euler_number(ConstImageView source, Connectivity objects, const Execution& execution) {
  const auto task = detail::task_for(objects, RegionsTask::euler_eight, RegionsTask::euler_four);
  return computed({task}, source, execution)->number();
}

void fill_holes(ConstImageView source, ImageView destination, const Execution& execution) {
  fill_holes(source, destination, Connectivity::eight, kAnyHoleArea, execution);
}

void fill_holes(ConstImageView source, ImageView destination, Connectivity objects,
                std::int64_t max_area, const Execution& execution) {
  detail::check_views(source, destination, detail::InPlace::allowed);
  const auto task = detail::task_for(objects, RegionsTask::fill, RegionsTask::fill_four);
  computed({task, max_area}, source, execution)->store(destination);
}

}  // namespace thinbench
