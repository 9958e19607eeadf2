// Edges on lanes, compiled once for every instruction-set level: gradient, brightest neighbour and
// decision in one sweep, 1 byte read and 1 byte (or bit) written a pixel.
//
// simd_16bit: magnitudes in 16 bits. Operations a batch of bytes for Sobel: 4 interleavings, 4
// multiply-adds of pairs, 8 additions and differences, 4 absolute values, 2 maxima, 2 subtractions
// that saturate, 1 pack; 4 maxima and 1 subtraction for P2; 3 to join and spread: 33. The loop at
// avx512 has 59 instructions, as counted in its assembly, 9 of them moves between registers.
// simd_8bit: Roberts' two differences fit bytes, and their rounded average decides exactly: 13
// operations a batch with P2, no interleaving.
// simd_to_bits: the faster of the two, a mask of bits stored instead of bytes: 1/8 of the bytes
// written.
//
// Tried and left out: Sobel in 8 bits, from averages of averages that are within one unit of the
// block sums, with batches computed again in 16 bits that hold a pixel within that unit of P1. On
// the test image it took 1.28 times the time of 16 bits at avx512, 0.97 at avx2 and 0.85 at sse4.2,
// and its time depends on the picture.
#include "dispatch/exported.hpp"
#include "edges/gradients.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

template <class Operator>
void to_bytes(const EdgeThresholds& thresholds, const ConstImageView& source,
              const ImageView& target, const EdgeRows& rows) {
  sweep_to_bytes<Operator>(thresholds, source, target, rows);
}

template <class Operator>
void to_bits(const EdgeThresholds& thresholds, const ConstImageView& source,
             const BitPlaneView& target, const EdgeRows& rows) {
  sweep_to_bits<Operator>(thresholds, source, target, rows);
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
