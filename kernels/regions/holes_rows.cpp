#include "regions/holes_rows.hpp"

#include <array>
#include <limits>

#include "regions/states.hpp"

namespace thinbench::detail {
namespace {

constexpr Index kAnyHolesWidth = std::numeric_limits<Index>::max();

constexpr HolesVariant row(Technique technique, MakeHolesState make, Isa isa = Isa::baseline,
                           bool threaded = false, Index max_width = kAnyHolesWidth) {
  return {technique, isa, threaded, max_width, make};
}

constexpr HolesVariant simd_runs(Isa isa, bool threaded = false) {
  return row(Technique::simd_runs, &make_simd_runs, isa, threaded, kSimdRunsWidth);
}

constexpr HolesVariant simd_euler(Isa isa, bool threaded = false) {
  return row(Technique::simd_bitpacked, &make_euler_simd, isa, threaded);
}

constexpr std::array kRegionRows = {
    row(Technique::union_find, &make_union_find),
    row(Technique::bitpacked_runs, &make_bitpacked_runs),
    row(Technique::bitpacked_runs, &make_bitpacked_runs, Isa::baseline, true),
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

constexpr std::array kEulerRows = {
    row(Technique::lut, &make_euler_lut),
    row(Technique::bitpacked, &make_euler_bitpacked),
    row(Technique::bitpacked, &make_euler_bitpacked, Isa::baseline, true),
    simd_euler(Isa::sse42),
    simd_euler(Isa::avx2),
    simd_euler(Isa::avx512),
    simd_euler(Isa::avx512icl),
    simd_euler(Isa::sse42, true),
    simd_euler(Isa::avx2, true),
    simd_euler(Isa::avx512, true),
    simd_euler(Isa::avx512icl, true),
};

constexpr std::array kFillRows = {
    row(Technique::union_find, &make_union_find_fill),
    row(Technique::bitpacked_runs, &make_bitpacked_fill),
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

}  // namespace thinbench::detail
