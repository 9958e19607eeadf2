#include <array>

#include "holes/states.hpp"
#include "localise/variant.hpp"

namespace thinbench {
namespace {

constexpr LocaliseVariant simd_runs(Isa isa, bool threaded = false) {
  return {{Technique::kSimdRuns, isa, threaded, kSimdRunsWidth}};
}

constexpr std::array kRows = {
    LocaliseVariant{{Technique::kBitpackedRuns, Isa::kBaseline, false}},
    LocaliseVariant{{Technique::kBitpackedRuns, Isa::kBaseline, true}},
    simd_runs(Isa::kBaseline),
    simd_runs(Isa::kSse42),
    simd_runs(Isa::kAvx2),
    simd_runs(Isa::kAvx512),
    simd_runs(Isa::kAvx512Icl),
    simd_runs(Isa::kBaseline, true),
    simd_runs(Isa::kSse42, true),
    simd_runs(Isa::kAvx2, true),
    simd_runs(Isa::kAvx512, true),
    simd_runs(Isa::kAvx512Icl, true),
};

}  // namespace

std::span<const LocaliseVariant> localise_rows() {
  return kRows;
}

}  // namespace thinbench
