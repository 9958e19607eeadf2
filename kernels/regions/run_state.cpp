#include "image/packing.hpp"
#include "image/planes.hpp"
#include "regions/run_labeller.hpp"
#include "regions/states.hpp"

namespace thinbench::detail {
namespace {

class RunState final : public HolesState {
 public:
  RunState(const RunEngine& engine, const HolesSetting& setting)
      : with_holes_(setting.task == HolesTask::holes),
        conversion_(plane_conversion<std::uint64_t>(setting.isa)),
        image_(setting.width, setting.height),
        labeller_(with_holes_ ? engine.holes : engine.components, setting.width, setting.height,
                  setting.threads) {}

  void load(const ConstImageView& source) override { conversion_.read(source, image_.view()); }
  void compute() override {
    lists_ = labeller_.label(image_.view());
    if (!with_holes_) lists_.holes = {};
  }
  [[nodiscard]] RegionLists regions() const override { return lists_; }
  [[nodiscard]] bool margins_are_zero() const override { return image_.margin_is_zero(); }

 private:
  bool with_holes_;
  const PlaneConversion<std::uint64_t>& conversion_;
  BitPlane image_;
  RunLabeller labeller_;
  RegionLists lists_;
};

}  // namespace

std::unique_ptr<HolesState> make_bitpacked_runs(const HolesSetting& setting) {
  return std::make_unique<RunState>(kBitpackedRunEngine, setting);
}

std::unique_ptr<HolesState> make_simd_runs(const HolesSetting& setting) {
  return std::make_unique<RunState>(simd_run_engine(setting.isa), setting);
}

}  // namespace thinbench::detail
