#include <atomic>

#include "image/packing.hpp"
#include "image/planes.hpp"
#include "image/thread_team.hpp"
#include "regions/euler.hpp"
#include "regions/states.hpp"

namespace thinbench::detail {
namespace {

class PackedState final : public HolesState {
 public:
  PackedState(const EulerKernels& kernels, const HolesSetting& setting)
      : kernel_(setting.task == HolesTask::euler_eight ? kernels.eight : kernels.four),
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
  [[nodiscard]] bool margins_are_zero() const override { return image_.margin_is_zero(); }

 private:
  EulerKernel kernel_;
  const PlaneConversion<std::uint64_t>& conversion_;
  BitPlane image_;
  ThreadTeam team_;
  std::atomic<std::int64_t> number_ = 0;
};

class ByteState final : public HolesState {
 public:
  ByteState(EulerQuads count, const HolesSetting& setting)
      : count_(count),
        conversion_(plane_conversion<std::uint8_t>(setting.isa)),
        image_(setting.width, setting.height) {}

  void load(const ConstImageView& source) override { conversion_.read(source, image_.view()); }
  void compute() override { number_ = count_(image_.view()); }
  [[nodiscard]] std::int64_t number() const override { return number_; }
  [[nodiscard]] bool margins_are_zero() const override { return image_.margin_is_zero(); }

 private:
  EulerQuads count_;
  const PlaneConversion<std::uint8_t>& conversion_;
  BytePlane image_;
  std::int64_t number_ = 0;
};

const EulerKernels& simd_kernels(Isa isa) {
  static constexpr const EulerKernels* kByLevel[] = {
      &IsaEuler<Isa::baseline>::kSimd, &IsaEuler<Isa::sse42>::kSimd, &IsaEuler<Isa::avx2>::kSimd,
      &IsaEuler<Isa::avx512>::kSimd, &IsaEuler<Isa::avx512icl>::kSimd};
  return *kByLevel[static_cast<std::size_t>(isa)];
}

}  // namespace

std::unique_ptr<HolesState> make_euler_lut(const HolesSetting& setting) {
  const bool eight = setting.task == HolesTask::euler_eight;
  return std::make_unique<ByteState>(eight ? &euler_by_quads_8 : &euler_by_quads_4, setting);
}

std::unique_ptr<HolesState> make_euler_bitpacked(const HolesSetting& setting) {
  return std::make_unique<PackedState>(kBitpackedEuler, setting);
}

std::unique_ptr<HolesState> make_euler_simd(const HolesSetting& setting) {
  return std::make_unique<PackedState>(simd_kernels(setting.isa), setting);
}

}  // namespace thinbench::detail
