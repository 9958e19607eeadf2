// Conversions between byte images and planes of bytes. Compiled per ISA.
#include "simd/vector.hpp"
#include "techniques/byte_planes.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

void read_bytes(const ConstImageView& source, const BytePlaneView& target) {
  if (source.width == 0) return;  // such rows need no memory
  const Index width = source.width;
  const Index height = source.height;
  for (Index y = 0; y < height; ++y) {
    const std::uint8_t* __restrict from = source.row(y);
    std::uint8_t* __restrict to = target.row(y);
    for (Index x = 0; x < width; ++x) to[x] = from[x] != 0 ? 1 : 0;
  }
}

void write_bytes(const ConstBytePlaneView& source, const ImageView& target) {
  if (source.width == 0) return;  // such rows need no memory
  const Index width = source.width;
  const Index height = source.height;
  for (Index y = 0; y < height; ++y) {
    const std::uint8_t* __restrict from = source.row(y);
    std::uint8_t* __restrict to = target.row(y);
    for (Index x = 0; x < width; ++x) to[x] = static_cast<std::uint8_t>(-from[x]);
  }
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const PlaneConversion<std::uint8_t>
    Exported<PlaneConversion<std::uint8_t>, kThisIsa>::kKernels = {&read_bytes, &write_bytes,
                                                                   &write_bytes};

}  // namespace thinbench::detail
