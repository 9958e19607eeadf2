#include "holes/holes_rows.hpp"

#include <array>
#include <limits>

#include "holes/states.hpp"

namespace thinbench {
namespace {

constexpr Index kAnyHolesWidth = std::numeric_limits<Index>::max();

constexpr HolesVariant row(Technique technique, MakeHolesState make, Isa isa = Isa::kBaseline,
                           bool threaded = false, Index max_width = kAnyHolesWidth) {
  return {technique, isa, threaded, max_width, make};
}

constexpr HolesVariant simd_runs(Isa isa, bool threaded = false) {
  return row(Technique::kSimdRuns, &make_simd_runs, isa, threaded, kSimdRunsWidth);
}

constexpr HolesVariant simd_euler(Isa isa, bool threaded = false) {
  return row(Technique::kSimdBitpacked, &make_euler_simd, isa, threaded);
}

constexpr std::array kRegionRows = {
    row(Technique::kUnionFind, &make_union_find),
    row(Technique::kBitpackedRuns, &make_bitpacked_runs),
    row(Technique::kBitpackedRuns, &make_bitpacked_runs, Isa::kBaseline, true),
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

constexpr std::array kEulerRows = {
    row(Technique::kLut, &make_euler_lut),
    row(Technique::kBitpacked, &make_euler_bitpacked),
    row(Technique::kBitpacked, &make_euler_bitpacked, Isa::kBaseline, true),
    simd_euler(Isa::kSse42),
    simd_euler(Isa::kAvx2),
    simd_euler(Isa::kAvx512),
    simd_euler(Isa::kAvx512Icl),
    simd_euler(Isa::kSse42, true),
    simd_euler(Isa::kAvx2, true),
    simd_euler(Isa::kAvx512, true),
    simd_euler(Isa::kAvx512Icl, true),
};

constexpr std::array kFillRows = {
    row(Technique::kUnionFind, &make_union_find_fill),
    row(Technique::kBitpackedRuns, &make_bitpacked_fill),
};

}  // namespace

std::span<const HolesVariant> region_rows() {
  return kRegionRows;
}

std::span<const HolesVariant> euler_rows() {
  return kEulerRows;
}

std::span<const HolesVariant> fill_rows() {
  return kFillRows;
}

}  // namespace thinbench
