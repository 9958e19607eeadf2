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
  count_runs<band>(image, first);
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
  for (Index y = 0; y < image.height; ++y) {
    std::int32_t* const row = labels.row(y);
    Index painted = 0;
    for_runs_of_row<band>(image, y, runs, [&](Index begin, Index end, Label id) {
      for (; painted < begin; ++painted) row[painted] = 0;
      for (; painted < end; ++painted) row[painted] = static_cast<std::int32_t>(id);
    });
    for (; painted < image.width; ++painted) row[painted] = 0;
  }
}

template <Band band>
constexpr LabelKernels kKernels = {&count<band>, &unite_all<band>, &number<band>, &sum<band>,
                                   &paint<band>};

}  // namespace

constinit const LabelEngine kBitpackedLabelEngine = {kKernels<Band::pair>, kKernels<Band::row>};

}  // namespace thinbench::detail
