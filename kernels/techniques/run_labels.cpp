// Label images from lists of labelled runs: objects and holes in one forest.
//
// Cost: that of labelled_runs.hpp, two look-ups per run, and four bytes stored per pixel.
#include <algorithm>

#include "regions/labelled_runs.hpp"
#include "techniques/regions.hpp"

namespace thinbench::detail {
namespace {

/// Writes row y, without its first `skipped` pixels, from the labels of holes and of objects.
template <class OfHole, class OfObject>
void paint_row(LabelledRuns& labelled, Index y, Index skipped, std::int32_t* row, Index width,
               const OfHole& of_hole, const OfObject& of_object) {
  const RunRow runs = labelled.row(y);
  for (Index i = 0; i <= runs.count; ++i) {
    const Index begin = i == 0 ? 0 : column_of(runs.keys[i - 1]) - skipped;
    const Index end = i == runs.count ? width : column_of(runs.keys[i]) - skipped;
    const Label root = labelled.roots(static_cast<int>(i % 2))[runs.labels[i]];
    const Index first = std::clamp<Index>(begin, 0, width);
    std::fill_n(row + first, std::clamp<Index>(end, first, width) - first,
                i % 2 == 0 ? of_hole(root) : of_object(root));
  }
}

constexpr auto kNoLabel = [](Label) { return std::int32_t{0}; };
constexpr auto kObjectId = [](Label index) { return static_cast<std::int32_t>(index + 1); };

class RunLabelsState final : public LabelsState {
 public:
  explicit RunLabelsState(const LabelsSetting& setting)
      : LabelsState(setting), task_(setting.task), runs_(setting.width, setting.height) {}

  [[nodiscard]] RegionLists regions() const override {
    return has_list(task_) ? lists_ : RegionLists{};
  }
  [[nodiscard]] Label objects() const override { return static_cast<Label>(lists_.objects.size()); }

 private:
  void compute() override {
    lists_ = runs_.label_and_number(image());
    if (task_ != LabelsTask::regions) lists_.holes = {};
  }

  void store(const LabelView& labels) override {
    const auto hole_id = [objects = objects()](Label hole) {
      return static_cast<std::int32_t>(hole == 0 ? 0 : objects + hole);
    };
    for (Index y = 0; y < labels.height; ++y) {
      if (task_ == LabelsTask::regions) {
        paint_row(runs_, y, 0, labels.row(y), labels.width, hole_id, kObjectId);
      } else {
        paint_row(runs_, y, 0, labels.row(y), labels.width, kNoLabel, kObjectId);
      }
    }
  }

  LabelsTask task_;
  LabelledRuns runs_;
  RegionLists lists_;
};

/// The image with foreground and background exchanged, in a frame of foreground one pixel wide.
void write_framed_complement(const ConstImageView& source, const ImageView& framed) {
  for (Index y = 0; y < framed.height; ++y) {
    std::fill_n(framed.row(y), framed.width, std::uint8_t{1});
  }
  for (Index y = 0; y < source.height; ++y) {
    std::transform(source.row(y), source.row(y) + source.width, framed.row(y + 1) + 1,
                   [](std::uint8_t pixel) { return static_cast<std::uint8_t>(pixel == 0); });
  }
}

/// A hole in the framed complement as an object of the image.
Region without_frame(Region region) {
  region.sum_x -= region.area;
  region.sum_y -= region.area;
  for (std::int32_t* side : {&region.left, &region.top, &region.right, &region.bottom}) --*side;
  region.enclosing_object = 0;
  return region;
}

LabelsSetting framed_setting(LabelsSetting setting) {
  setting.width += 2;
  setting.height += 2;
  return setting;
}

/// Holes are 4-connected, so the image's 4-connected objects are the holes of its complement.
class FramedLabelsState final : public LabelsState {
 public:
  explicit FramedLabelsState(const LabelsSetting& setting)
      : LabelsState(framed_setting(setting)),
        task_(setting.task),
        framed_(setting.width + 2, setting.height + 2),
        runs_(setting.width + 2, setting.height + 2) {}

  [[nodiscard]] RegionLists regions() const override {
    return has_list(task_) ? RegionLists{objects_, {}} : RegionLists{};
  }
  [[nodiscard]] Label objects() const override { return static_cast<Label>(objects_.size()); }

 private:
  void load(const ConstImageView& source) override {
    write_framed_complement(source, framed_.view());
    LabelsState::load(framed_.view());
  }

  void compute() override {
    const std::span<const Region> holes = runs_.label_and_number(image()).holes;
    objects_.resize(holes.size());
    std::transform(holes.begin(), holes.end(), objects_.begin(), without_frame);
  }

  void store(const LabelView& labels) override {
    const auto hole_id = [](Label hole) { return static_cast<std::int32_t>(hole); };
    for (Index y = 0; y < labels.height; ++y) {
      paint_row(runs_, y + 1, 1, labels.row(y), labels.width, hole_id, kNoLabel);
    }
  }

  LabelsTask task_;
  ByteImage framed_;
  LabelledRuns runs_;
  std::vector<Region> objects_;
};

}  // namespace

std::unique_ptr<LabelsState> make_run_labels(const LabelsSetting& setting) {
  if (is_four_connected(setting.task)) return std::make_unique<FramedLabelsState>(setting);
  return std::make_unique<RunLabelsState>(setting);
}

}  // namespace thinbench::detail
