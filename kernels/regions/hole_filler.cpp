#include "regions/hole_filler.hpp"

#include <algorithm>

#include "core/exported.hpp"
#include "regions/run_bits.hpp"

namespace thinbench::detail {
namespace {

/// Calls `visit(run, y, word, bits)` for every run of the background in every word that it has
/// pixels in, with these. About 15 instructions per run.
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

}  // namespace

HoleFiller::HoleFiller(Isa isa, const HoleFilling& filling)
    : kernels_(kernels_of<LabelEngine>(isa).holes), max_area_(filling.max_area) {
  const FloodKernels& floods = kernels_of<FloodKernels>(isa);
  const bool eight = filling.objects == Connectivity::four;  // the background
  flood_ = eight ? floods.eight : floods.four;
  background_ = eight ? Connectivity::eight : Connectivity::four;
}

void HoleFiller::fill(const ConstBitPlaneView& image, const BitPlaneView& filled) {
  if (image.height == 0) return;
  if (max_area_ == kAnyHoleArea && flood_(image, filled)) return;
  if (!runs_) runs_.emplace(kernels_, image.width, image.height);
  fill_runs(image, filled);
}

void HoleFiller::fill_runs(const ConstBitPlaneView& image, const BitPlaneView& filled) {
  const Background background = runs_->of(image, background_);
  Label* const parents = background.runs.parents;
  const Label count = background.runs.first[image.height];
  for (Label run = 0; run < count; ++run) parents[run] = parents[parents[run]];
  choose_holes(background);
  for (Index y = 0; y < image.height; ++y) {
    std::copy_n(image.row(y), image.row_elements, filled.row(y));
  }
  for_each_run(background, [&](Label run, Index y, Index word, std::uint64_t bits) {
    filled.row(y)[word] |= bits & chosen_[parents[run]];
  });
}

/// Sets `chosen_` of the first run of each hole to all ones or to 0; 0 for the outside.
void HoleFiller::choose_holes(const Background& background) {
  const Label* const parents = background.runs.parents;
  const bool all = max_area_ == kAnyHoleArea;
  chosen_.assign(background.runs.first[background.image.height], all ? ~std::uint64_t{0} : 0);
  if (!all) {
    for_each_run(background, [&](Label run, Index, Index, std::uint64_t bits) {
      chosen_[parents[run]] += count_bits(bits);
    });
    for (std::uint64_t& area : chosen_) {
      area = area <= static_cast<std::uint64_t>(max_area_) ? ~std::uint64_t{0} : 0;
    }
  }
  chosen_[0] = 0;
}

}  // namespace thinbench::detail
