#include "thinbench/regions.hpp"

#include "core/checks.hpp"
#include "regions/state.hpp"

namespace thinbench {
namespace {

using detail::LabelParameters;
using detail::LabelTask;

/// The best state for an image.
template <class Parameters>
auto state_for(const Parameters& parameters, const ConstImageView& source,
               const Execution& execution) {
  return detail::make_best_state(detail::operation_of(parameters), source.width, source.height,
                                 parameters, execution);
}

Regions lists_of(const ConstImageView& source, bool with_holes, const Execution& execution) {
  detail::check(detail::memory_of("source", source));
  Regions found;
  state_for(detail::ListParameters{with_holes}, source, execution)->run(source, found);
  return found;
}

/// Writes the labels, sets the lists of the task, and returns the number of objects.
std::uint32_t label(const ConstImageView& source, const LabelView& labels,
                    const LabelParameters& parameters, const Execution& execution, Regions& found) {
  detail::require_label_size(source.width, source.height);
  detail::check(detail::memory_of("source", source), detail::memory_of("labels", labels),
                detail::InPlace::rejected);
  return state_for(parameters, source, execution)->run(source, labels, found);
}

LabelTask task_for(Connectivity connectivity, LabelTask eight, LabelTask four) {
  detail::require_connectivity(static_cast<int>(connectivity));
  return connectivity == Connectivity::four ? four : eight;
}

}  // namespace

Regions find_regions(ConstImageView source, const Execution& execution) {
  return lists_of(source, true, execution);
}

std::vector<Region> find_objects(ConstImageView source, const Execution& execution) {
  return lists_of(source, false, execution).objects;
}

Regions label_regions(ConstImageView source, LabelView labels, const Execution& execution) {
  Regions found;
  label(source, labels, {LabelTask::regions}, execution, found);
  return found;
}

std::vector<Region> label_objects(ConstImageView source, LabelView labels,
                                  Connectivity connectivity, LabelOrder order,
                                  const Execution& execution) {
  const LabelTask task = task_for(connectivity, LabelTask::objects_eight, LabelTask::objects_four);
  Regions found;
  label(source, labels, {task, order}, execution, found);
  return std::move(found.objects);
}

std::uint32_t label_image(ConstImageView source, LabelView labels, Connectivity connectivity,
                          LabelOrder order, const Execution& execution) {
  const LabelTask task = task_for(connectivity, LabelTask::image_eight, LabelTask::image_four);
  Regions none;
  return label(source, labels, {task, order}, execution, none);
}

std::int64_t euler_number(ConstImageView source, Connectivity objects, const Execution& execution) {
  detail::check(detail::memory_of("source", source));
  return state_for(detail::EulerParameters{objects}, source, execution)->run(source);
}

void fill_holes(ConstImageView source, ImageView destination, const HoleFilling& filling,
                const Execution& execution) {
  detail::check_views(source, destination, detail::InPlace::allowed);
  state_for(filling, source, execution)->run(source, destination);
}

}  // namespace thinbench
