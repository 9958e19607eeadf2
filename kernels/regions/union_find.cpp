// Two passes over bytes, as in textbooks: provisional labels from the neighbours already seen,
// joined in a union-find forest; then every pixel is summed up under its region.
//
// Cost a pixel: up to 4 look-ups of neighbours' labels, 4 bytes written and read again, and 12
// operations to sum up, with branches that follow the picture. It is what run-based labelling has
// to beat; it should win nowhere but on noise of single pixels, where a run is a pixel.
#include "image/packing.hpp"
#include "image/planes.hpp"
#include "regions/label_store.hpp"
#include "regions/variants.hpp"

namespace thinbench::detail {
namespace {

/// Labels of both colours; their frame, one pixel wide, is label 0 of the background.
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

class TwoPasses {
 public:
  explicit TwoPasses(const RegionsSetting& setting)
      : conversion_(plane_conversion<std::uint8_t>(setting.isa)),
        image_(setting.width, setting.height),
        labels_(setting.width, setting.height),
        store_(setting.width) {}

  void load(const ConstImageView& source) { conversion_.read(source, image_.view()); }

  /// The first pass; afterwards a row at the lower border has met the frame.
  void label() {
    store_.clear();
    const ConstBytePlaneView image = image_.view();
    for (Index y = 0; y < image.height; ++y) {
      store_.make_room((image.width + 1) / 2);
      label_row(image, y);
    }
    if (image.height > 0) join_lower_border(image);
  }

  /// The second pass.
  RegionLists sum_up() {
    const RegionLists lists = store_.number_regions();
    const ConstBytePlaneView image = image_.view();
    const LabelTables& tables = store_.tables();
    for (Index y = 0; y < image.height; ++y) {
      const std::uint8_t* pixels = image.row(y);
      const Label* labels = labels_.row(y);
      for (Index x = 0; x < image.width; ++x) {
        const LabelTable& table = tables.of_colour[pixels[x]];
        add_run(table.regions[table.parents[labels[x]]], x, x + 1, y);
      }
    }
    return lists;
  }

  /// The other second pass: 255 on objects and in holes.
  void fill(const ImageView& target) {
    static_cast<void>(store_.number_regions());
    const ConstBytePlaneView image = image_.view();
    const Label* const holes = store_.tables().of_colour[0].parents;
    for (Index y = 0; y < image.height; ++y) {
      const std::uint8_t* pixels = image.row(y);
      const Label* labels = labels_.row(y);
      std::uint8_t* to = target.row(y);
      for (Index x = 0; x < image.width; ++x) {
        to[x] = pixels[x] != 0 || holes[labels[x]] != 0 ? 255 : 0;
      }
    }
  }


 private:
  void label_row(const ConstBytePlaneView& image, Index y) {
    const std::uint8_t* pixels = image.row(y);
    Label* labels = labels_.row(y);
    for (Index x = 0; x < image.width; ++x) {
      labels[x] = pixels[x] != 0 ? dark_label(pixels + x, image.stride, labels + x, y)
                                 : light_label(pixels + x, image.stride, labels + x, y);
    }
    Label* const parents = store_.tables().of_colour[0].parents;
    if (image.width > 0 && pixels[image.width - 1] == 0) {
      unite(parents, 0, labels[image.width - 1]);
    }
  }

  Label dark_label(const std::uint8_t* pixel, Index stride, const Label* label, Index y) {
    LabelTable& table = store_.tables().of_colour[1];
    const std::uint8_t* north = pixel - stride;
    const Label* label_north = label - labels_.stride();
    if (north[0] != 0) return label_north[0];  // touches the other three
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

  Label light_label(const std::uint8_t* pixel, Index stride, const Label* label, Index y) {
    LabelTable& table = store_.tables().of_colour[0];
    const bool west = pixel[-1] == 0;
    if (pixel[-stride] != 0) return west ? label[-1] : new_label(table, y, label[-1]);
    const Label north = label[-labels_.stride()];
    return west ? unite(table.parents, label[-1], north) : north;
  }

  void join_lower_border(const ConstBytePlaneView& image) {
    Label* const parents = store_.tables().of_colour[0].parents;
    const std::uint8_t* pixels = image.row(image.height - 1);
    const Label* labels = labels_.row(image.height - 1);
    for (Index x = 0; x < image.width; ++x) {
      if (pixels[x] == 0) unite(parents, 0, labels[x]);
    }
  }

  const PlaneConversion<std::uint8_t>& conversion_;
  BytePlane image_;
  LabelPlane labels_;
  LabelStore store_;
};

class RegionState final : public RegionsState {
 public:
  explicit RegionState(const RegionsSetting& setting)
      : with_holes_(setting.task == RegionsTask::holes), passes_(setting) {}

  void load(const ConstImageView& source) override { passes_.load(source); }
  void compute() override {
    passes_.label();
    lists_ = passes_.sum_up();
    if (!with_holes_) lists_.holes = {};
  }
  [[nodiscard]] RegionLists regions() const override { return lists_; }

 private:
  bool with_holes_;
  TwoPasses passes_;
  RegionLists lists_;
};

class FillState final : public RegionsState {
 public:
  explicit FillState(const RegionsSetting& setting)
      : passes_(setting), filled_(setting.width, setting.height) {}

  void load(const ConstImageView& source) override { passes_.load(source); }
  void compute() override {
    passes_.label();
    passes_.fill(filled_.view());
  }
  void store(const ImageView& destination) const override {
    for (Index y = 0; y < destination.height; ++y) {
      const std::uint8_t* from = filled_.view().row(y);
      for (Index x = 0; x < destination.width; ++x) destination.row(y)[x] = from[x];
    }
  }

 private:
  TwoPasses passes_;
  ByteImage filled_;
};

}  // namespace

std::unique_ptr<RegionsState> make_union_find(const RegionsSetting& setting) {
  return std::make_unique<RegionState>(setting);
}

std::unique_ptr<RegionsState> make_union_find_fill(const RegionsSetting& setting) {
  return std::make_unique<FillState>(setting);
}

}  // namespace thinbench::detail
