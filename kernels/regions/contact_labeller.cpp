#include "regions/contact_labeller.hpp"

#include "core/exported.hpp"
#include "regions/run_numbers.hpp"

namespace thinbench::detail {
namespace {

constexpr Region kNoPixels = {0, 0, 0, INT32_MAX, 0, -1, 0, 0};

constexpr bool is_four_connected(LabelTask task) {
  return task == LabelTask::image_four || task == LabelTask::objects_four;
}

constexpr BandKind band_of(LabelTask task) {
  return is_four_connected(task) ? BandKind::row : BandKind::pair;
}

}  // namespace

RunForest RunForestMemory::with_room() {
  const Label runs = first_[static_cast<std::size_t>(bands_)];
  if (runs >= capacity_) {
    const std::size_t larger = std::size_t{runs} + runs / 2 + 1;
    capacity_ = 0;  // in case that memory is short
    parents_ = make_aligned<Label>(larger);
    ids_ = make_aligned<Label>(larger + 2 * std::size_t{kRunPadding});
    capacity_ = larger;
  }
  return {parents_.get(), ids_.get() + kRunPadding, first_.get()};
}

Background BackgroundRuns::of(const ConstBitPlaneView& image, Connectivity connectivity) {
  kernels_.invert(image, inverted_.view());
  kernels_.count(inverted_.view(), memory_.first());
  const Background background = {inverted_.view(), memory_.with_room()};
  const bool with_corners = connectivity == Connectivity::eight;
  (with_corners ? kernels_.unite_with_corners : kernels_.unite)(background);
  return background;
}

ContactLabeller::ContactLabeller(const LabelParameters& parameters, Isa isa, Index width,
                                 Index height)
    : engine_(kernels_of<LabelEngine>(isa)),
      kernels_(is_four_connected(parameters.task) ? engine_.four : engine_.eight),
      parameters_(parameters),
      memory_(bands_of(band_of(parameters.task), height)) {
  if (parameters.task == LabelTask::regions) background_runs_.emplace(engine_.holes, width, height);
}

Label ContactLabeller::find(const ConstBitPlaneView& image, Regions& found) {
  kernels_.count(image, memory_.first());
  runs_ = memory_.with_room();
  kernels_.unite(image, runs_);
  const Label count = runs_.first[bands_of(band_of(parameters_.task), image.height)];
  // OpenCV's blocks: no two runs of a pair of rows share one, so they are in the same order.
  const Label objects = parameters_.order == LabelOrder::opencv
                            ? number_in_order(runs_, 0, count, 0)
                            : kernels_.number(image, runs_);
  if (parameters_.task == LabelTask::regions) {
    find_holes(image, objects, found);
  } else if (parameters_.task >= LabelTask::objects_eight) {
    found.objects.assign(objects, kNoPixels);
    kernels_.sum(image, runs_, found.objects.data());
  }
  return objects;
}

void ContactLabeller::find_holes(const ConstBitPlaneView& image, Label objects, Regions& found) {
  background_ = background_runs_->of(image, Connectivity::four);
  const Label last = engine_.holes.number(background_, objects);
  regions_.assign(last + std::size_t{1}, kNoPixels);
  // Between two runs of a row in the foreground is one in the background.
  const auto rows = static_cast<std::size_t>(image.height);
  ids_.resize(2 * std::size_t{background_.runs.first[rows]} + rows + 2 * std::size_t{kRunPadding});
  engine_.holes.sum({image, runs_, objects}, background_, regions_.data(),
                    ids_.data() + kRunPadding);
  const auto first_hole = regions_.begin() + 1 + static_cast<std::ptrdiff_t>(objects);
  found.objects.assign(regions_.begin() + 1, first_hole);
  found.holes.assign(first_hole, regions_.end());
}

void ContactLabeller::paint(const ConstBitPlaneView& image, const LabelView& labels) const {
  if (parameters_.task == LabelTask::regions) {
    engine_.holes.paint(image, background_.image, ids_.data() + kRunPadding, labels);
  } else {
    kernels_.paint(image, runs_, labels);
  }
}

}  // namespace thinbench::detail
