#include "midpoints/variants.hpp"

#include "dispatch/exported.hpp"
#include "midpoints/state.hpp"

namespace thinbench::detail {
namespace {

using enum Technique;
using State = std::unique_ptr<ThinningState>;

State make_bitpacked_scan(const ThinningSetting& setting) {
  return std::make_unique<ScanState>(kBitpackedScan, setting);
}

State make_simd_scan(const ThinningSetting& setting) {
  return std::make_unique<ScanState>(kernels_of<ScanKernels>(setting.isa), setting);
}

/// The scan on bytes.
class ByteScanState final : public PlaneState<std::uint8_t> {
 public:
  explicit ByteScanState(const ThinningSetting& setting)
      : PlaneState(setting),
        kernels_(kernels_of<ByteScanKernels>(setting.isa)),
        directions_(setting.directions),
        border_(setting.border),
        scratch_(make_aligned<std::uint64_t>(
            static_cast<std::size_t>(kernels_.scratch_words(setting.width, setting.height)))) {}

  int thin() override {
    kernels_.run(directions_, source(), planes.result.view(), scratch_.get());
    apply_border(border_, source(), planes.result.view());
    return 1;
  }

 private:
  const ByteScanKernels& kernels_;
  Directions directions_;
  Border border_;
  AlignedArray<std::uint64_t> scratch_;
};

State make_byte_scan(const ThinningSetting& setting) {
  return std::make_unique<ByteScanState>(setting);
}

}  // namespace

// No look-up table and no bytes by hand: docs/experiments.md#other-techniques-for-the-scan.
std::vector<ThinningVariant> midpoint_variants() {
  ThinningVariants list;
  list.add_with_threads(bitpacked, Isa::baseline, &make_bitpacked_scan, {1});
  for (const Isa isa : kAllIsas) {
    list.add(autovec, isa, &make_byte_scan, {0});
    list.add_with_threads(simd_bitpacked, isa, &make_simd_scan, {2});
  }
  return list.take();
}

}  // namespace thinbench::detail
