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
  unite_runs<band>(image, runs);
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

void count_background(const ConstBitPlaneView& image, Label* first) {
  count_runs<Band::background>(image, 1, first);
}

void unite_holes(const ConstBitPlaneView& image, const RunForest& runs) {
  unite_background(image, runs);
}

Label number_holes(const ConstBitPlaneView& image, const RunForest& runs, Label objects) {
  runs.ids[0] = 0;
  return number_in_order(runs, 1, runs.first[image.height], objects);
}

void sum_all_holes(const ConstBitPlaneView& image, const RunForest& foreground,
                   const RunForest& background, Label objects, Region* holes) {
  sum_holes(image, foreground, background, objects, holes);
}

void paint_all(const ConstBitPlaneView& image, const RunForest& foreground,
               const RunForest& background, const LabelView& labels) {
  paint_all_runs(image, foreground, background, labels);
}

constexpr HoleKernels kHoleKernels = {&count_background, &unite_holes, &number_holes,
                                      &sum_all_holes, &paint_all};

}  // namespace

constinit const LabelEngine kBitpackedLabelEngine = {kKernels<Band::pair>, kKernels<Band::row>,
                                                     kHoleKernels};

}  // namespace thinbench::detail
