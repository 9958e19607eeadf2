#include "techniques/midpoints.hpp"

#include "core/exported.hpp"

namespace thinbench::detail {
namespace {

/// The scan on bytes.
class ByteScanState final : public MidpointPlanes<std::uint8_t> {
 public:
  explicit ByteScanState(const MidpointSetting& setting)
      : MidpointPlanes(setting),
        kernels_(kernels_of<ByteScanKernels>(setting.isa)),
        directions_(setting.directions),
        scratch_(make_aligned<std::uint64_t>(
            static_cast<std::size_t>(kernels_.scratch_words(setting.width, setting.height)))) {}

 private:
  void mark() override {
    kernels_.run(directions_, planes.source.view(), planes.result.view(), scratch_.get());
  }

  const ByteScanKernels& kernels_;
  Directions directions_;
  AlignedArray<std::uint64_t> scratch_;
};

std::unique_ptr<MidpointState> make_byte_scan(const MidpointSetting& setting) {
  return std::make_unique<ByteScanState>(setting);
}

std::unique_ptr<MidpointState> make_bitpacked_scan(const MidpointSetting& setting) {
  return make_midpoint_scan(kBitpackedScan, setting);
}

}  // namespace

VariantList<MidpointState> midpoint_techniques() {
  VariantList<MidpointState> list;
  list.add_with_threads("bitpacked", Isa::baseline, &make_bitpacked_scan, {1});
  for (const Isa isa : isas_of<ByteScanKernels>()) list.add("autovec", isa, &make_byte_scan, {0});
  return list;
}

}  // namespace thinbench::detail
