// Label images by words of 64 pixels.
//
// Cost, for 8-connected objects: per 128 pixels about 40 instructions to find and join runs; per
// run 7 and two memory accesses to join it with one above, 5 and three to number it; per run of a
// row 12 to paint it, and its pixels as stores of four.
#include "regions/run_bits.hpp"

namespace thinbench::detail {
namespace {

template <Band band>
void count(const ConstBitPlaneView& image, Label* first) {
  count_runs<band>(image, 0, first);
}

template <Band band>
void unite_all(const ConstBitPlaneView& image, const RunForest& runs) {
  unite_runs<band>(image, runs, [&](Index number) { unite_band<band>(image, number, runs); });
}

template <Band band>
Label number(const ConstBitPlaneView& image, const RunForest& runs) {
  return number_runs<band>(image, runs);
}

template <Band band>
void sum(const ConstBitPlaneView& image, const RunForest& runs, Region* objects) {
  sum_runs<band>(image, runs, objects);
}

template <Band band>
void paint(const ConstBitPlaneView& image, const RunForest& runs, const LabelView& labels) {
  paint_runs<band>(image, runs, labels);
}

template <Band band>
constexpr LabelKernels kKernels = {&count<band>, &unite_all<band>, &number<band>, &sum<band>,
                                   &paint<band>};

void invert(const ConstBitPlaneView& image, const BitPlaneView& background) {
  write_background(image, background);
}

void count_background(const ConstBitPlaneView& background, Label* first) {
  count_runs<Band::row>(background, 1, first);
}

void unite_holes(const Background& background) {
  const auto& [image, runs] = background;
  unite_background(image, runs, [&](Index y) { unite_band<Band::row>(image, y, runs); });
}

Label number_holes(const Background& background, Label objects) {
  background.runs.ids[0] = 0;
  return number_in_order(background.runs, 1, background.runs.first[background.image.height],
                         objects);
}

void sum_all(const Objects& objects, const Background& background, Region* regions) {
  sum_all_runs<Band::pair>(objects, background, regions);
}

void paint_all(const Objects& objects, const Background& background, const LabelView& labels) {
  paint_all_runs(objects, background, labels);
}

constexpr HoleKernels kHoleKernels = {&invert,       &count_background, &unite_holes,
                                      &number_holes, &sum_all,          &paint_all};

}  // namespace

constinit const LabelEngine kBitpackedLabelEngine = {kKernels<Band::pair>, kKernels<Band::row>,
                                                     kHoleKernels};

}  // namespace thinbench::detail
