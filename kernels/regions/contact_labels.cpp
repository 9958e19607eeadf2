#include "regions/contact_labels.hpp"

#include <vector>

#include "core/exported.hpp"
#include "regions/run_forest.hpp"

namespace thinbench::detail {
namespace {

constexpr Region kNoPixels = {0, 0, 0, INT32_MAX, 0, -1, 0, 0};

class ContactLabelsState : public LabelsState {
 public:
  ContactLabelsState(const LabelEngine& engine, const LabelsSetting& setting)
      : LabelsState(setting),
        kernels_(is_four_connected(setting.task) ? engine.four : engine.eight),
        has_list_(has_list(setting.task)),
        memory_(bands_of(is_four_connected(setting.task) ? BandKind::row : BandKind::pair,
                         setting.height)) {}

  [[nodiscard]] RegionLists regions() const override { return {list_, {}}; }
  [[nodiscard]] Label objects() const override { return objects_; }

 protected:
  void find_objects() {
    kernels_.count(image(), memory_.first());
    runs_ = memory_.with_room();
    kernels_.unite(image(), runs_);
    objects_ = kernels_.number(image(), runs_);
  }
  void compute() override {
    find_objects();
    if (!has_list_) return;
    list_.assign(objects_, kNoPixels);
    kernels_.sum(image(), runs_, list_.data());
  }
  void store(const LabelView& labels) override { kernels_.paint(image(), runs_, labels); }

  [[nodiscard]] const RunForest& runs() const { return runs_; }

 private:
  LabelKernels kernels_;
  bool has_list_;
  RunForestMemory memory_;
  RunForest runs_ = {};
  Label objects_ = 0;
  std::vector<Region> list_;
};

class ContactRegionsState final : public ContactLabelsState {
 public:
  ContactRegionsState(const LabelEngine& engine, const LabelsSetting& setting)
      : ContactLabelsState(engine, setting),
        kernels_(engine.holes),
        inverted_(setting.width, setting.height),
        memory_(setting.height) {}

  [[nodiscard]] RegionLists regions() const override {
    const std::span<const Region> all(regions_);
    if (all.empty()) return {};  // no pixels
    return {all.subspan(1, objects()), all.subspan(1 + objects())};
  }

 private:
  void compute() override {
    find_objects();
    kernels_.invert(image(), inverted_.view());
    kernels_.count(inverted_.view(), memory_.first());
    background_ = {inverted_.view(), memory_.with_room()};
    kernels_.unite(background_);
    regions_.assign(kernels_.number(background_, objects()) + std::size_t{1}, kNoPixels);
    ids_.resize(max_row_runs() + 2 * std::size_t{kRunPadding});
    kernels_.sum({image(), runs(), objects()}, background_, regions_.data(), ids());
  }
  void store(const LabelView& labels) override {
    kernels_.paint(image(), background_.image, ids(), labels);
  }

  /// Between two runs of a row in the foreground is one in the background.
  [[nodiscard]] std::size_t max_row_runs() {
    const auto height = static_cast<std::size_t>(image().height);
    return 2 * std::size_t{memory_.first()[height]} + height;
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

std::unique_ptr<LabelsState> make_contact_labels(const LabelsSetting& setting) {
  const LabelEngine& engine = kernels_of<LabelEngine>(setting.isa);
  if (setting.task == LabelsTask::regions) {
    return std::make_unique<ContactRegionsState>(engine, setting);
  }
  return std::make_unique<ContactLabelsState>(engine, setting);
}

}  // namespace thinbench::detail
