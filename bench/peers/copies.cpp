// Lower bounds: a copy of the bytes for everything that reads a byte and writes a byte per pixel;
// for packed images the packed words copied, where an operation gives an image, or read, where it
// gives numbers.
#include <cstring>

#include "core/packing.hpp"
#include "core/planes.hpp"
#include "harness/library_operation.hpp"
#include "peers/peers.hpp"

namespace thinbench {
namespace {

using detail::BitPlane;
using detail::BitPlaneView;
using detail::kWordBits;
using detail::PlaneConversion;

JobMaker copy() {
  return job_maker<NoNumbers>([](const auto& input, const auto& output, auto&) {
    const auto bytes = static_cast<std::size_t>(input.width);
    for (Index y = 0; y < input.height && bytes > 0; ++y) {
      std::memcpy(output.row(y), input.row(y), bytes);
    }
  });
}

/// The reference: plain code.
JobMaker plain_copy() {
  return job_maker<NoNumbers>([](const auto& input, const auto& output, auto&) {
    for (Index y = 0; y < input.height; ++y) {
      for (Index x = 0; x < input.width; ++x) output.row(y)[x] = input.row(y)[x];
    }
  });
}

Index words_of(const BitPlaneView& plane) {
  return (plane.width + kWordBits - 1) / kWordBits;
}

class CopyBitsJob final : public Job {
 public:
  CopyBitsJob(Index width, Index height)
      : conversion_(detail::plane_conversion<std::uint64_t>(best_isa())),
        source_(width, height),
        target_(width, height) {}

  void load(const ConstImageView& input) override { conversion_.read(input, source_.view()); }
  void kernel() override {
    const BitPlaneView from = source_.view();
    const auto bytes = static_cast<std::size_t>(words_of(from) * 8);
    for (Index y = 0; y < from.height && bytes > 0; ++y) {
      std::memcpy(target_.view().row(y), from.row(y), bytes);
    }
  }
  void store(const ImageView& output) const override { conversion_.write(target_.view(), output); }

 private:
  const PlaneConversion<std::uint64_t>& conversion_;
  BitPlane source_;
  BitPlane target_;
};

/// All words combined by exclusive or: what must look at every word.
struct Combined : OneNumber {
  [[nodiscard]] static std::string name_of_number(std::size_t) { return "words combined"; }
};

class ReadBitsJob final : public ResultJob<Combined> {
 public:
  ReadBitsJob(Index width, Index height)
      : conversion_(detail::plane_conversion<std::uint64_t>(best_isa())), source_(width, height) {}

  void load(const ConstImageView& input) override { conversion_.read(input, source_.view()); }
  void kernel() override {
    const BitPlaneView from = source_.view();
    const Index words = words_of(from);
    std::uint64_t combined = 0;
    for (Index y = 0; y < from.height; ++y) {
      const std::uint64_t* row = from.row(y);
      for (Index i = 0; i < words; ++i) combined ^= row[i];
    }
    result.number = static_cast<std::int64_t>(combined);
  }

 private:
  const PlaneConversion<std::uint64_t>& conversion_;
  BitPlane source_;
};

/// The reference: plain code.
JobMaker plain_read() {
  return job_maker<Combined>([](const auto& input, const auto&, Combined& combined) {
    combined = {};
    for (Index y = 0; y < input.height; ++y) {
      for (Index x = 0; x < input.width; ++x) {
        if (input.row(y)[x] != 0)
          combined.number ^= static_cast<std::int64_t>(std::uint64_t{1} << x % kWordBits);
      }
    }
  });
}

std::vector<Variant> with_kernel_scope(Variant peer) {
  peer.has_kernel_scope = true;
  return {peer};
}

}  // namespace

std::vector<Variant> copy_peers(const Operation& operation) {
  if (operation.takes != InputKind::grey) return {};
  return {peer_variant("copy", "no operation: the same bytes copied", copy(), plain_copy())};
}

std::vector<Variant> copy_bits_peers(const Operation& operation) {
  if (operation.name.starts_with("fill_holes")) {
    return with_kernel_scope(peer_variant(
        "copy_bits", "no operation: the packed words copied",
        [](Index width, Index height, int) { return std::make_unique<CopyBitsJob>(width, height); },
        plain_copy()));
  }
  for (const char* name : {"holes", "objects", "euler_number", "euler_number_4"}) {
    if (operation.name != name) continue;
    return with_kernel_scope(peer_variant(
        "read_bits", "no operation: the image packed, its words read",
        [](Index width, Index height, int) { return std::make_unique<ReadBitsJob>(width, height); },
        plain_read()));
  }
  return {};
}

}  // namespace thinbench
