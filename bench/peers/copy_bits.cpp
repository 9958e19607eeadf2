// The limit of everything that reads packed images: the packed words copied.
#include <cstring>

#include "core/convert.hpp"
#include "core/planes.hpp"
#include "peers/peers.hpp"

namespace thinbench {
namespace {

class CopyBitsJob final : public Job {
 public:
  CopyBitsJob(Index width, Index height)
      : conversion_(plane_conversion<std::uint64_t>(best_isa())),
        source_(width, height),
        target_(width, height) {}

  void run(const ConstByteView& input, const ByteView& output) override {
    load(input);
    kernel();
    store(output);
  }
  void load(const ConstByteView& input) override { conversion_.read(input, source_.view()); }
  void kernel() override {
    const BitPlaneView from = source_.view();
    const auto bytes = static_cast<std::size_t>((from.width + kWordBits - 1) / kWordBits * 8);
    for (Index y = 0; y < from.height && bytes > 0; ++y) {
      std::memcpy(target_.view().row(y), from.row(y), bytes);
    }
  }
  void store(const ByteView& output) const override { conversion_.write(target_.view(), output); }

 private:
  const PlaneConversion<std::uint64_t>& conversion_;
  BitPlane source_;
  BitPlane target_;
};

/// Plain enough to be looked through.
class PlainCopyJob final : public Job {
 public:
  void run(const ConstByteView& input, const ByteView& output) override {
    for (Index y = 0; y < input.height; ++y) {
      for (Index x = 0; x < input.width; ++x) output.row(y)[x] = input.row(y)[x];
    }
  }
};

}  // namespace

std::vector<Variant> copy_bits_peers(const Operation& operation) {
  if (operation.name != "holes" && operation.name != "euler_number") return {};
  Variant copy = peer_variant(
      "copy_bits", "no operation: the packed words copied",
      [](Index width, Index height, int) { return std::make_unique<CopyBitsJob>(width, height); },
      [](Index, Index, int) { return std::make_unique<PlainCopyJob>(); });
  copy.has_kernel_scope = true;
  return {copy};
}

}  // namespace thinbench
