#include "regions/contact_labels.hpp"

#include <vector>

#include "core/exported.hpp"
#include "regions/run_forest.hpp"
#include "regions/run_numbers.hpp"

namespace thinbench::detail {
namespace {

constexpr Region kNoPixels = {0, 0, 0, INT32_MAX, 0, -1, 0, 0};

class ObjectLabels : public ContactLabels {
 public:
  ObjectLabels(const LabelEngine& engine, const LabelsParameters& parameters, Index height)
      : kernels_(is_four_connected(parameters.task) ? engine.four : engine.eight),
        has_list_(has_list(parameters.task)),
        order_(parameters.order),
        bands_(
            bands_of(is_four_connected(parameters.task) ? BandKind::row : BandKind::pair, height)),
        memory_(bands_) {}

  void find(const ConstBitPlaneView& image) override {
    find_objects(image);
    if (!has_list_) return;
    list_.assign(objects_, kNoPixels);
    kernels_.sum(image, runs_, list_.data());
  }
  [[nodiscard]] RegionLists regions() const override { return {list_, {}}; }
  [[nodiscard]] Label objects() const override { return objects_; }
  void paint(const ConstBitPlaneView& image, const LabelView& labels) const override {
    kernels_.paint(image, runs_, labels);
  }

 protected:
  void find_objects(const ConstBitPlaneView& image) {
    kernels_.count(image, memory_.first());
    runs_ = memory_.with_room();
    kernels_.unite(image, runs_);
    // OpenCV's blocks: no two runs of a pair of rows share one, so they are in the same order.
    objects_ = order_ == LabelOrder::opencv ? number_in_order(runs_, 0, runs_.first[bands_], 0)
                                            : kernels_.number(image, runs_);
  }
  [[nodiscard]] const RunForest& runs() const { return runs_; }

 private:
  LabelKernels kernels_;
  bool has_list_;
  LabelOrder order_;
  Index bands_;
  RunForestMemory memory_;
  RunForest runs_ = {};
  Label objects_ = 0;
  std::vector<Region> list_;
};

class RegionLabels final : public ObjectLabels {
 public:
  RegionLabels(const LabelEngine& engine, const LabelsParameters& parameters, Index width,
               Index height)
      : ObjectLabels(engine, parameters, height),
        kernels_(engine.holes),
        inverted_(width, height),
        memory_(height) {}

  void find(const ConstBitPlaneView& image) override {
    find_objects(image);
    kernels_.invert(image, inverted_.view());
    kernels_.count(inverted_.view(), memory_.first());
    background_ = {inverted_.view(), memory_.with_room()};
    kernels_.unite(background_);
    regions_.assign(kernels_.number(background_, objects()) + std::size_t{1}, kNoPixels);
    ids_.resize(max_row_runs(image.height) + 2 * std::size_t{kRunPadding});
    kernels_.sum({image, runs(), objects()}, background_, regions_.data(), ids());
  }
  [[nodiscard]] RegionLists regions() const override {
    const std::span<const Region> all(regions_);
    if (all.empty()) return {};  // no pixels
    return {all.subspan(1, objects()), all.subspan(1 + objects())};
  }
  void paint(const ConstBitPlaneView& image, const LabelView& labels) const override {
    kernels_.paint(image, background_.image, ids_.data() + kRunPadding, labels);
  }

 private:
  /// Between two runs of a row in the foreground is one in the background.
  [[nodiscard]] std::size_t max_row_runs(Index height) {
    const auto rows = static_cast<std::size_t>(height);
    return 2 * std::size_t{memory_.first()[rows]} + rows;
  }
  [[nodiscard]] Label* ids() { return ids_.data() + kRunPadding; }

  HoleKernels kernels_;
  BitPlane inverted_;
  RunForestMemory memory_;
  Background background_ = {};
  std::vector<Region> regions_;  // outside, objects, holes
  std::vector<Label> ids_;       // of all runs of rows
};

}  // namespace

std::unique_ptr<ContactLabels> make_contact_labels(const LabelsParameters& parameters, Isa isa,
                                                   Index width, Index height) {
  const LabelEngine& engine = kernels_of<LabelEngine>(isa);
  if (parameters.task == LabelsTask::regions) {
    return std::make_unique<RegionLabels>(engine, parameters, width, height);
  }
  return std::make_unique<ObjectLabels>(engine, parameters, height);
}

}  // namespace thinbench::detail
