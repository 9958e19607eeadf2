// Edges on byte lanes, compiled per ISA: gradient, brightest neighbour and decision in one
// scan, with 1 byte read and 1 byte (or bit) written per pixel.
//
// simd_16bit: magnitudes in 16 bits. Operations per batch of bytes for Sobel: 4 interleavings, 4
// multiply-adds of pairs, 8 additions and subtractions, 4 absolute values, 2 maxima, 2 saturating
// subtractions, 1 pack; 4 maxima and 1 subtraction for the brightness; 3 to combine both and write
// bytes: 33. The avx512 loop has 59 instructions in its assembly, 9 of them register moves.
// simd_8bit: Roberts' two differences fit bytes, and their rounded average decides exactly: 13
// operations per batch including brightness, without interleaving.
// to_bits: the faster of the two, but stores bits: 1/8 of the bytes written.
//
// Alternatives not adopted: docs/experiments.md#edges.
#include "core/exported.hpp"
#include "edges/gradients.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

template <class Operator>
void to_bytes(const EdgeThresholds& thresholds, const ConstImageView& source,
              const ImageView& target, const EdgeRows& rows) {
  scan_to_bytes<Operator>(thresholds, source, target, rows);
}

template <class Operator>
void to_bits(const EdgeThresholds& thresholds, const ConstImageView& source,
             const BitPlaneView& target, const EdgeRows& rows) {
  scan_to_bits<Operator>(thresholds, source, target, rows);
}

}  // namespace

}  // namespace THINBENCH_ISA

template <>
constinit const EdgeKernels Exported<EdgeKernels, kThisIsa>::kKernels = {
    {{&to_bytes<Roberts4In16Bits>, &to_bytes<Roberts9In16Bits>, &to_bytes<MeroVassyIn16Bits>,
      &to_bytes<MeroVassy5x5In16Bits>, &to_bytes<SobelIn16Bits>, &to_bytes<PrewittIn16Bits>}},
    {{&to_bytes<Roberts4In8Bits>, &to_bytes<Roberts9In8Bits>}},
    {{&to_bits<Roberts4In8Bits>, &to_bits<Roberts9In8Bits>, &to_bits<MeroVassyIn16Bits>,
      &to_bits<MeroVassy5x5In16Bits>, &to_bits<SobelIn16Bits>, &to_bits<PrewittIn16Bits>}}};

}  // namespace thinbench::detail
