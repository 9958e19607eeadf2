#include "thinbench/regions.hpp"

#include "core/checks.hpp"
#include "regions/label_image.hpp"
#include "regions/state.hpp"

namespace thinbench {
namespace {

using detail::RegionsState;
using detail::RegionsTask;

/// A state that holds the result.
std::unique_ptr<RegionsState> computed(RegionsTask task, const ConstImageView& source,
                                       const Execution& execution) {
  detail::check_views(source, source, detail::InPlace::allowed);
  auto state = detail::make_best_state(detail::operation_of(task), source.width, source.height,
                                       {task}, execution);
  state->load(source);
  state->compute();
  return state;
}

/// Rejects views that label images cannot be made of; returns whether there are pixels.
bool check_labels(const ConstImageView& source, const LabelView& labels) {
  detail::require_label_size(source.width, source.height);
  detail::check_views(source, labels);
  return source.width > 0 && source.height > 0;
}

}  // namespace

Regions find_regions(ConstImageView source, const Execution& execution) {
  const auto state = computed(RegionsTask::holes, source, execution);
  const detail::RegionLists lists = state->regions();
  return {{lists.objects.begin(), lists.objects.end()}, {lists.holes.begin(), lists.holes.end()}};
}

std::vector<Region> find_components(ConstImageView source, const Execution& execution) {
  const auto state = computed(RegionsTask::components, source, execution);
  const detail::RegionLists lists = state->regions();
  return {lists.objects.begin(), lists.objects.end()};
}

Regions label_regions(ConstImageView source, LabelView labels) {
  return check_labels(source, labels) ? detail::paint_regions(source, labels) : Regions{};
}

std::vector<Region> label_components(ConstImageView source, LabelView labels,
                                     Connectivity connectivity) {
  detail::require(
      connectivity == Connectivity::four || connectivity == Connectivity::eight,
      "connectivity: expected 4 or 8, got " + std::to_string(static_cast<int>(connectivity)));
  if (!check_labels(source, labels)) return {};
  return connectivity == Connectivity::four ? detail::paint_four_connected(source, labels)
                                            : detail::paint_eight_connected(source, labels);
}

std::int64_t euler_number(ConstImageView source, const Execution& execution) {
  return computed(RegionsTask::euler_eight, source, execution)->number();
}

std::int64_t euler_number_4(ConstImageView source, const Execution& execution) {
  return computed(RegionsTask::euler_four, source, execution)->number();
}

void fill_holes(ConstImageView source, ImageView destination, const Execution& execution) {
  detail::check_views(source, destination, detail::InPlace::allowed);
  computed(RegionsTask::fill, source, execution)->store(destination);
}

}  // namespace thinbench
