#include "regions/fill_state.hpp"

#include <optional>
#include <vector>

#include "core/exported.hpp"
#include "regions/fill_kernels.hpp"
#include "regions/run_bits.hpp"
#include "regions/run_forest.hpp"

namespace thinbench::detail {
namespace {

/// Calls `visit(run, y, word, bits)` for every run of the background in every word that it has
/// pixels in, with these.
template <class Visit>
void for_each_run(const Background& background, const Visit& visit) {
  for (Index y = 0; y < background.image.height; ++y) {
    BandBits<BandKind::row> here(background.image, y);
    Label run = background.runs.first[y] - 1;  // the last one before a word
    for (Index word = 0; word < words_of(background.image); ++word) {
      const std::uint64_t starts = here.starts(word);
      for (std::uint64_t left = here.top(word); left != 0;) {
        const std::uint64_t bits = left & ~(left + (left & ~(left - 1)));
        if ((bits & starts) != 0) ++run;
        visit(run, y, word, bits);
        left &= ~bits;
      }
    }
  }
}

/// Fills holes by labels of the background's runs.
///
/// Cost: that of label_kernels.cpp for runs of single rows, and for each run about 15 instructions
/// to write it, and as many to measure its area.
class RunFill {
 public:
  RunFill(const HoleKernels& kernels, bool with_corners, Index width, Index height)
      : kernels_(kernels), with_corners_(with_corners), inverted_(width, height), memory_(height) {}

  void operator()(const ConstBitPlaneView& image, const BitPlaneView& filled,
                  std::int64_t max_area) {
    kernels_.invert(image, inverted_.view());
    kernels_.count(inverted_.view(), memory_.first());
    const Background background = {inverted_.view(), memory_.with_room()};
    (with_corners_ ? kernels_.unite_with_corners : kernels_.unite)(background);
    const RunForest& runs = background.runs;
    const Label count = runs.first[image.height];
    for (Label run = 0; run < count; ++run) runs.parents[run] = runs.parents[runs.parents[run]];
    choose_holes(background, count, max_area);
    for (Index y = 0; y < image.height; ++y) {
      std::copy_n(image.row(y), image.row_elements, filled.row(y));
    }
    for_each_run(background, [&](Label run, Index y, Index word, std::uint64_t bits) {
      filled.row(y)[word] |= bits & chosen_[runs.parents[run]];
    });
  }

 private:
  /// Sets `chosen_` of the first run of each hole to all ones or to 0; 0 for the outside.
  void choose_holes(const Background& background, Label count, std::int64_t max_area) {
    const bool all = max_area == kAnyHoleArea;
    chosen_.assign(count, all ? ~std::uint64_t{0} : 0);
    if (!all) {
      for_each_run(background, [&](Label run, Index, Index, std::uint64_t bits) {
        chosen_[background.runs.parents[run]] += count_bits(bits);
      });
      for (std::uint64_t& area : chosen_) {
        area = area <= static_cast<std::uint64_t>(max_area) ? ~std::uint64_t{0} : 0;
      }
    }
    chosen_[0] = 0;
  }

  HoleKernels kernels_;
  bool with_corners_;
  BitPlane inverted_;
  RunForestMemory memory_;
  std::vector<std::uint64_t> chosen_;
};

class FillState final : public RegionsPlaneState<std::uint64_t> {
 public:
  explicit FillState(const RegionsSetting& setting)
      : RegionsPlaneState(setting),
        holes_(kernels_of<LabelEngine>(setting.isa).holes),
        with_corners_(setting.task == RegionsTask::fill_four),
        flood_(flood_of(kernels_of<FloodKernels>(setting.isa))),
        max_area_(setting.max_area),
        result_(setting.width, setting.height) {}

  void compute() override {
    if (image().height == 0) return;
    if (max_area_ == kAnyHoleArea && flood_(image(), result_.view())) return;
    if (!runs_) runs_.emplace(holes_, with_corners_, image().width, image().height);
    (*runs_)(image(), result_.view(), max_area_);
  }
  void store(const ImageView& destination) const override {
    conversion().write(result_.view(), destination);
  }

 private:
  [[nodiscard]] FloodBackground flood_of(const FloodKernels& kernels) const {
    return with_corners_ ? kernels.eight : kernels.four;
  }

  HoleKernels holes_;
  bool with_corners_;
  FloodBackground flood_;
  std::int64_t max_area_;
  BitPlane result_;
  std::optional<RunFill> runs_;
};

}  // namespace

std::unique_ptr<RegionsState> make_fill(const RegionsSetting& setting) {
  return std::make_unique<FillState>(setting);
}

}  // namespace thinbench::detail
