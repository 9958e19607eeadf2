#include <array>

#include "regions/states.hpp"
#include "localise/variant.hpp"

namespace thinbench::detail {
namespace {

constexpr LocaliseVariant simd_runs(Isa isa, bool threaded = false) {
  return {{Technique::simd_runs, isa, threaded, kSimdRunsWidth}};
}

constexpr std::array kRows = {
    LocaliseVariant{{Technique::bitpacked_runs, Isa::baseline, false}},
    LocaliseVariant{{Technique::bitpacked_runs, Isa::baseline, true}},
    simd_runs(Isa::baseline),
    simd_runs(Isa::sse42),
    simd_runs(Isa::avx2),
    simd_runs(Isa::avx512),
    simd_runs(Isa::avx512icl),
    simd_runs(Isa::baseline, true),
    simd_runs(Isa::sse42, true),
    simd_runs(Isa::avx2, true),
    simd_runs(Isa::avx512, true),
    simd_runs(Isa::avx512icl, true),
};

}  // namespace

std::span<const LocaliseVariant> localise_rows() {
  return kRows;
}

}  // namespace thinbench::detail
