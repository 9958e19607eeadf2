// The scanning skeleton on xsimd batches, compiled once for every instruction-set level; see
// sweep.hpp. A row of up to 511 pixels is one batch on AVX-512, where every gate is one
// instruction and 9 counter bits twice, with what they are compared with, stay in registers.
#include "core/batch.hpp"
#include "scan/engine.hpp"

namespace thinbench {

template <>
constinit const ScanKernels IsaScan<kThisIsa>::kSimdBitpacked =
    ScanEngine<WordBatch, kThisIsa>::kKernels;

}  // namespace thinbench
