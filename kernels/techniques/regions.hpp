// Regions by techniques that are compared with those of the product.
#pragma once

#include "regions/state.hpp"
#include "techniques/byte_planes.hpp"

namespace thinbench::detail {

/// The states of lists by union-find over the runs of one row after the other.
[[nodiscard]] std::unique_ptr<ListState> make_bitpacked_runs(const ListSetting& setting);

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

/// Regions of images of one size by union-find on pixels.
class UnionFind {
 public:
  UnionFind(Index width, Index height);

  void find(const ConstImageView& source, bool with_holes, Regions& found);
  void fill(const ConstImageView& source, const ImageView& destination);

 private:
  void label(const ConstImageView& source);
  void label_row(Index y);
  Label foreground_label(const std::uint8_t* pixel, const Label* label, Index y);
  Label background_label(const std::uint8_t* pixel, const Label* label, Index y);
  void join_lower_border();

  BytePlane image_;
  LabelPlane labels_;
  LabelStore store_;
};

/// Euler numbers by a look-up table.
class EulerQuads {
 public:
  EulerQuads(Connectivity objects, Index width, Index height);

  [[nodiscard]] std::int64_t run(const ConstImageView& source);

 private:
  std::int64_t (*count_)(const ConstBytePlaneView& image);
  BytePlane image_;
};

}  // namespace thinbench::detail
