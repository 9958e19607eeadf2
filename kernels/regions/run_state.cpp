#include "dispatch/exported.hpp"
#include "image/packing.hpp"
#include "image/planes.hpp"
#include "regions/run_labeller.hpp"
#include "regions/variants.hpp"

namespace thinbench::detail {
namespace {

class RunState final : public RegionsState {
 public:
  RunState(const RunEngine& engine, const RegionsSetting& setting)
      : with_holes_(setting.task == RegionsTask::holes),
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

 private:
  bool with_holes_;
  const PlaneConversion<std::uint64_t>& conversion_;
  BitPlane image_;
  RunLabeller labeller_;
  RegionLists lists_;
};

}  // namespace

std::unique_ptr<RegionsState> make_bitpacked_runs(const RegionsSetting& setting) {
  return std::make_unique<RunState>(kBitpackedRunEngine, setting);
}

std::unique_ptr<RegionsState> make_simd_runs(const RegionsSetting& setting) {
  return std::make_unique<RunState>(kernels_of<RunEngine>(setting.isa), setting);
}

}  // namespace thinbench::detail
