// Textbook two-pass labelling of bytes: the first pass takes provisional labels from the neighbours
// already visited and joins them in a union-find forest; the second adds every pixel to its region.
//
// Cost per pixel: up to 4 look-ups of neighbours' labels, 4 bytes written and read again, and 12
// operations to sum, with unpredictable branches. The baseline for run-based labelling:
// docs/experiments.md#regions.
#include "techniques/regions.hpp"

namespace thinbench::detail {
namespace {

/// Labels of both colours, with a margin one pixel wide that has label 0 of the background.
class LabelPlane {
 public:
  LabelPlane(Index width, Index height)
      : stride_(width + 2),
        labels_(make_aligned<Label>(static_cast<std::size_t>(stride_ * (height + 2)))) {}

  [[nodiscard]] Label* row(Index y) { return labels_.get() + (y + 1) * stride_ + 1; }
  [[nodiscard]] Index stride() const { return stride_; }

 private:
  Index stride_;
  AlignedArray<Label> labels_;
};

class UnionFindState : public RegionsPlaneState<std::uint8_t> {
 public:
  explicit UnionFindState(const RegionsSetting& setting)
      : RegionsPlaneState(setting), labels_(setting.width, setting.height), store_(setting.width) {}

 protected:
  /// The first pass; joins background at the image border with the outside.
  void label() {
    store_.clear();
    for (Index y = 0; y < image().height; ++y) {
      store_.make_room((image().width + 1) / 2);
      label_row(y);
    }
    if (image().height > 0) join_lower_border();
  }

  [[nodiscard]] LabelStore& store_of_labels() { return store_; }
  [[nodiscard]] const Label* labels(Index y) { return labels_.row(y); }

 private:
  void label_row(Index y) {
    const ConstBytePlaneView image = this->image();
    const std::uint8_t* pixels = image.row(y);
    Label* labels = labels_.row(y);
    for (Index x = 0; x < image.width; ++x) {
      labels[x] = pixels[x] != 0 ? foreground_label(pixels + x, image.stride, labels + x, y)
                                 : background_label(pixels + x, image.stride, labels + x, y);
    }
    if (image.width > 0 && pixels[image.width - 1] == 0) {
      unite(store_.tables().of_colour[0].parents, 0, labels[image.width - 1]);
    }
  }

  Label foreground_label(const std::uint8_t* pixel, Index stride, const Label* label, Index y) {
    LabelTable& table = store_.tables().of_colour[1];
    const std::uint8_t* north = pixel - stride;
    const Label* label_north = label - labels_.stride();
    if (north[0] != 0) return label_north[0];  // already joined with the other three
    const bool east = north[1] != 0;
    Label joined = 0;
    if (pixel[-1] != 0) {
      joined = label[-1];
    } else if (north[-1] != 0) {
      joined = label_north[-1];
    } else {
      return east ? label_north[1] : new_label(table, y, 0);
    }
    return east ? unite(table.parents, joined, label_north[1]) : joined;
  }

  Label background_label(const std::uint8_t* pixel, Index stride, const Label* label, Index y) {
    LabelTable& table = store_.tables().of_colour[0];
    const bool west = pixel[-1] == 0;
    if (pixel[-stride] != 0) return west ? label[-1] : new_label(table, y, label[-1]);
    const Label north = label[-labels_.stride()];
    return west ? unite(table.parents, label[-1], north) : north;
  }

  void join_lower_border() {
    Label* const parents = store_.tables().of_colour[0].parents;
    const std::uint8_t* pixels = image().row(image().height - 1);
    const Label* labels = labels_.row(image().height - 1);
    for (Index x = 0; x < image().width; ++x) {
      if (pixels[x] == 0) unite(parents, 0, labels[x]);
    }
  }

  LabelPlane labels_;
  LabelStore store_;
};

class ListState final : public UnionFindState {
 public:
  explicit ListState(const RegionsSetting& setting)
      : UnionFindState(setting), with_holes_(setting.task == RegionsTask::holes) {}

  void compute() override {
    label();
    lists_ = store_of_labels().number_regions();
    sum_up();
    if (!with_holes_) lists_.holes = {};
  }
  [[nodiscard]] RegionLists regions() const override { return lists_; }

 private:
  /// The second pass.
  void sum_up() {
    const ConstBytePlaneView image = this->image();
    const LabelTables& tables = store_of_labels().tables();
    for (Index y = 0; y < image.height; ++y) {
      const std::uint8_t* pixels = image.row(y);
      const Label* row = labels(y);
      for (Index x = 0; x < image.width; ++x) {
        const LabelTable& table = tables.of_colour[pixels[x]];
        add_run(table.regions[table.parents[row[x]]], x, x + 1, y);
      }
    }
  }

  bool with_holes_;
  RegionLists lists_;
};

class FillState final : public UnionFindState {
 public:
  explicit FillState(const RegionsSetting& setting)
      : UnionFindState(setting), filled_(setting.width, setting.height) {}

  void compute() override {
    label();
    static_cast<void>(store_of_labels().number_regions());
    fill();
  }
  void store(const ImageView& destination) const override {
    for (Index y = 0; y < destination.height; ++y) {
      const std::uint8_t* from = filled_.view().row(y);
      for (Index x = 0; x < destination.width; ++x) destination.row(y)[x] = from[x];
    }
  }

 private:
  /// The second pass: 255 on objects and in holes.
  void fill() {
    const ConstBytePlaneView image = this->image();
    const Label* const holes = store_of_labels().tables().of_colour[0].parents;
    for (Index y = 0; y < image.height; ++y) {
      const std::uint8_t* pixels = image.row(y);
      const Label* row = labels(y);
      std::uint8_t* to = filled_.view().row(y);
      for (Index x = 0; x < image.width; ++x) {
        to[x] = pixels[x] != 0 || holes[row[x]] != 0 ? 255 : 0;
      }
    }
  }

  ByteImage filled_;
};

}  // namespace

std::unique_ptr<RegionsState> make_union_find(const RegionsSetting& setting) {
  return std::make_unique<ListState>(setting);
}

std::unique_ptr<RegionsState> make_union_find_fill(const RegionsSetting& setting) {
  return std::make_unique<FillState>(setting);
}

}  // namespace thinbench::detail
