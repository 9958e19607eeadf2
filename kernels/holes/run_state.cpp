#include <algorithm>
#include <deque>

#include "core/convert.hpp"
#include "core/planes.hpp"
#include "core/thread_team.hpp"
#include "holes/run_band.hpp"
#include "holes/states.hpp"

namespace thinbench {
namespace {

/// Bands of rows, one a thread, labelled on their own and joined at the seams.
class RunState final : public HolesState {
 public:
  RunState(const RunEngine& engine, const HolesSetting& setting)
      : with_holes_(setting.task == HolesTask::kHoles),
        label_rows_(with_holes_ ? engine.holes : engine.components),
        conversion_(plane_conversion<std::uint64_t>(setting.isa)),
        image_(setting.width, setting.height),
        team_(setting.threads) {
    const Index bands = std::min<Index>(setting.threads, setting.height);
    for (Index band = 0; band < bands; ++band) bands_.emplace_back(setting.width);
  }

  void load(const ConstByteView& source) override { conversion_.read(source, image_.view()); }

  void compute() override {
    if (bands_.empty()) return;
    label_bands();
    LabelStore& labels = bands_.front().labels();
    for (std::size_t i = 1; i < bands_.size(); ++i) {
      join_bands(labels, bands_[i - 1].last_row(), bands_[i]);
    }
    join_border(labels.tables(), bands_.front().first_row());
    join_border(labels.tables(), bands_.back().last_row());
    lists_ = labels.number_regions();
    if (!with_holes_) lists_.holes = {};
  }

  [[nodiscard]] RegionLists regions() const override { return lists_; }
  [[nodiscard]] bool margins_are_zero() const override { return image_.margin_is_zero(); }

 private:
  void label_bands() {
    const ConstBitPlaneView image = image_.view();
    const auto count = static_cast<Index>(bands_.size());
    team_.for_ranges(count, [&](Index first, Index last) {
      for (Index band = first; band < last; ++band) {
        bands_[static_cast<std::size_t>(band)].label(
            label_rows_, image, image.height * band / count, image.height * (band + 1) / count);
      }
    });
  }

  bool with_holes_;
  LabelRows label_rows_;
  const PlaneConversion<std::uint64_t>& conversion_;
  BitPlane image_;
  ThreadTeam team_;
  std::deque<RunBand> bands_;
  RegionLists lists_;
};

const RunEngine& simd_engine(Isa isa) {
  static constexpr const RunEngine* kByLevel[] = {
      &RunEngines<Isa::kBaseline>::kSimd, &RunEngines<Isa::kSse42>::kSimd,
      &RunEngines<Isa::kAvx2>::kSimd, &RunEngines<Isa::kAvx512>::kSimd,
      &RunEngines<Isa::kAvx512Icl>::kSimd};
  return *kByLevel[static_cast<std::size_t>(isa)];
}

}  // namespace

std::unique_ptr<HolesState> make_bitpacked_runs(const HolesSetting& setting) {
  return std::make_unique<RunState>(kBitpackedRunEngine, setting);
}

std::unique_ptr<HolesState> make_simd_runs(const HolesSetting& setting) {
  return std::make_unique<RunState>(simd_engine(setting.isa), setting);
}

}  // namespace thinbench
