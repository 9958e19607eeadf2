// The Euler number: on 64-bit words for any processor, and by a table of 2 x 2 quads on bytes.
//
// Cost of bitpacked per 64 pixels: 4 loads, 4 operations for west neighbours, 6 gates and 2
// population counts (about 12 operations each without popcnt). Cost of lut per pixel: 2 loads, 2
// shifts, a look-up and an addition, in one dependency chain.
#include "regions/euler.hpp"

namespace thinbench::detail {
namespace {

template <class Connectivity>
std::int64_t count(const ConstBitPlaneView& image, Index first, Index last) {
  return sum_euler<Connectivity, std::uint64_t, WordCounter>(image, first, last);
}

/// Contributions of quads: c is bit 3, n bit 2, w bit 1 and nw bit 0.
struct QuadTable {
  std::int8_t of_quad[16] = {};
};

template <class Connectivity>
consteval QuadTable quad_table() {
  QuadTable table;
  for (unsigned quad = 0; quad < 16; ++quad) {
    const auto pixel = [quad](unsigned bit) { return quad >> bit & 1; };
    const auto terms =
        Connectivity::template terms<unsigned>(pixel(3), pixel(1), pixel(2), pixel(0));
    table.of_quad[quad] = static_cast<std::int8_t>(static_cast<int>(terms.plus & 1) -
                                                   static_cast<int>(terms.minus & 1));
  }
  return table;
}

template <class Connectivity>
std::int64_t count_quads(const ConstBytePlaneView& image) {
  static constexpr QuadTable kTable = quad_table<Connectivity>();
  std::int64_t total = 0;
  for (Index y = 0; y <= image.height; ++y) {
    const std::uint8_t* row = image.row(y);
    const std::uint8_t* above = image.row(y - 1);
    unsigned quad = 0;
    for (Index x = 0; x <= image.width; ++x) {
      quad = quad >> 2 | static_cast<unsigned>(above[x]) << 2 | static_cast<unsigned>(row[x]) << 3;
      total += kTable.of_quad[quad];
    }
  }
  return total;
}

}  // namespace

constinit const EulerKernels kBitpackedEuler = {&count<EulerEight>, &count<EulerFour>};
constinit const EulerPair<EulerQuadKernel> kEulerByQuads = {&count_quads<EulerEight>,
                                                            &count_quads<EulerFour>};

}  // namespace thinbench::detail
