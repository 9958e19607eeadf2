#include <atomic>

#include "dispatch/exported.hpp"
#include "image/packing.hpp"
#include "image/planes.hpp"
#include "image/thread_team.hpp"
#include "regions/euler.hpp"
#include "regions/variants.hpp"

namespace thinbench::detail {
namespace {

class PackedState final : public RegionsState {
 public:
  PackedState(const EulerKernels& kernels, const RegionsSetting& setting)
      : kernel_(setting.task == RegionsTask::euler_eight ? kernels.eight : kernels.four),
        conversion_(plane_conversion<std::uint64_t>(setting.isa)),
        image_(setting.width, setting.height),
        team_(setting.threads) {}

  void load(const ConstImageView& source) override { conversion_.read(source, image_.view()); }
  void compute() override {
    const ConstBitPlaneView image = image_.view();
    number_ = 0;
    team_.for_ranges(image.height + 1, [&](Index first, Index last) {
      number_.fetch_add(kernel_(image, first, last), std::memory_order_relaxed);
    });
  }
  [[nodiscard]] std::int64_t number() const override { return number_; }

 private:
  EulerKernel kernel_;
  const PlaneConversion<std::uint64_t>& conversion_;
  BitPlane image_;
  ThreadTeam team_;
  std::atomic<std::int64_t> number_ = 0;
};

class ByteState final : public RegionsState {
 public:
  ByteState(EulerQuads count, const RegionsSetting& setting)
      : count_(count),
        conversion_(plane_conversion<std::uint8_t>(setting.isa)),
        image_(setting.width, setting.height) {}

  void load(const ConstImageView& source) override { conversion_.read(source, image_.view()); }
  void compute() override { number_ = count_(image_.view()); }
  [[nodiscard]] std::int64_t number() const override { return number_; }

 private:
  EulerQuads count_;
  const PlaneConversion<std::uint8_t>& conversion_;
  BytePlane image_;
  std::int64_t number_ = 0;
};

}  // namespace

std::unique_ptr<RegionsState> make_euler_lut(const RegionsSetting& setting) {
  const bool eight = setting.task == RegionsTask::euler_eight;
  return std::make_unique<ByteState>(eight ? &euler_by_quads_8 : &euler_by_quads_4, setting);
}

std::unique_ptr<RegionsState> make_euler_bitpacked(const RegionsSetting& setting) {
  return std::make_unique<PackedState>(kBitpackedEuler, setting);
}

std::unique_ptr<RegionsState> make_euler_simd(const RegionsSetting& setting) {
  return std::make_unique<PackedState>(kernels_of<EulerKernels>(setting.isa), setting);
}

}  // namespace thinbench::detail
