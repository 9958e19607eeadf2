// Label images from runs as bits. Compiled per ISA.
//
// Cost, for 8-connected objects: per 128 pixels about 45 instructions to find runs and contacts, or
// per 1024 pixels about 70 where a register holds eight words; per run 7 instructions and two
// memory accesses to join it with one above, 10 and three to number it; painting is that of
// label_painter.hpp, or without permutations of lanes 12 instructions per run of a row and a store
// per pixel.
#include "core/exported.hpp"
#include "regions/label_painter.hpp"
#include "regions/run_blocks.hpp"
#include "regions/run_numbers.hpp"
#include "regions/run_sums.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

template <BandKind band>
void count(const ConstBitPlaneView& image, Label* first) {
  count_runs<band>(image, 0, first);
}

/// Narrower images are faster word by word.
constexpr Index kMinBlockWidth = 193;

/// With fewer runs per word they are marked faster one by one.
constexpr Index kMinRunsForLanes = 5;

template <BandKind band>
[[gnu::always_inline]] inline void unite_with_above(const ConstBitPlaneView& image, Index number,
                                                    const RunForest& runs) {
  if constexpr (kHasRunBlocks) {
    if (image.width >= kMinBlockWidth) {
      unite_band_in_blocks<band, WordBatch>(image, number, runs);
      return;
    }
  }
  unite_band<band>(image, number, runs);
}

template <BandKind band>
void unite_all(const ConstBitPlaneView& image, const RunForest& runs) {
  unite_runs<band>(image, runs, [&](Index number) { unite_with_above<band>(image, number, runs); });
}

template <BandKind band>
Label number(const ConstBitPlaneView& image, const RunForest& runs) {
  return number_runs<band>(image, runs, [&](Index number) {
    if constexpr (kHasCompress) {
      const auto count = static_cast<Index>(runs.first[number + 1] - runs.first[number]);
      const bool is_dense = count > kMinRunsForLanes * words_of(image);
      if (is_dense) return mark_first_row_in_lanes<Lanes32>(image, number, runs);
    }
    return mark_first_row(image, number, runs);
  });
}

template <BandKind band>
void sum(const ConstBitPlaneView& image, const RunForest& runs, Region* objects) {
  sum_runs<band>(image, runs, objects);
}

template <BandKind band>
void paint(const ConstBitPlaneView& image, const RunForest& runs, const LabelView& labels) {
  if constexpr (kHasLanePermute) {
    paint_bands<band>(image, runs, labels);
  } else {
    paint_runs<band>(image, runs, labels);
  }
}

template <BandKind band>
constexpr LabelKernels kKernels = {&count<band>, &unite_all<band>, &number<band>, &sum<band>,
                                   &paint<band>};

void invert(const ConstBitPlaneView& image, const BitPlaneView& background) {
  write_background(image, background);
}

void count_background(const ConstBitPlaneView& background, Label* first) {
  count_runs<BandKind::row>(background, 1, first);
}

template <BandKind band>
void unite_holes(const Background& background) {
  unite_background(background,
                   [&](Index y) { unite_with_above<band>(background.image, y, background.runs); });
}

Label number_holes(const Background& background, Label objects) {
  background.runs.ids[0] = 0;
  return number_in_order(background.runs, 1, background.runs.first[background.image.height],
                         objects);
}

Label* sum_all(const Objects& objects, const Background& background, Region* regions, Label* ids) {
  return sum_all_runs<BandKind::pair>(objects, background, regions, ids);
}

template <BandKind band>
void paint_all(const ConstBitPlaneView& image, const ConstBitPlaneView& background,
               const Label* ids, const LabelView& labels) {
  if constexpr (kHasLanePermute) {
    paint_rows<band>(image, background, ids, labels);
  } else {
    paint_all_runs(image, background, ids, labels);
  }
}

constexpr HoleKernels kHoleKernels = {&invert,
                                      &count_background,
                                      &unite_holes<BandKind::row>,
                                      &unite_holes<BandKind::row_with_corners>,
                                      &number_holes,
                                      &sum_all,
                                      &paint_all<BandKind::row>};

}  // namespace

}  // namespace THINBENCH_ISA

template <>
constinit const LabelEngine Exported<LabelEngine, kThisIsa>::kKernels = {
    THINBENCH_ISA::kKernels<BandKind::pair>, THINBENCH_ISA::kKernels<BandKind::row>,
    THINBENCH_ISA::kHoleKernels};

}  // namespace thinbench::detail
