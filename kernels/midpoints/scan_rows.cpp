#include "midpoints/scan_rows.hpp"

#include <array>

namespace thinbench::detail {
namespace {

using enum Technique;

template <Isa isa>
constexpr ThinningVariant packed(bool threaded) {
  return {simd_bitpacked, isa, threaded, kAnyWidth, &IsaScan<isa>::kSimdBitpacked};
}

template <Isa isa>
constexpr ThinningVariant autovec_variant() {
  return {autovec, isa, kOneThread, kAnyWidth, &IsaScan<isa>::kAutovec};
}

constexpr ThinningVariant scalar(bool threaded) {
  return {bitpacked, Isa::baseline, threaded, kAnyWidth, &ScalarScan::kBitpacked};
}

// No look-up table: what makes a centre may lie as far away as the run is long. No lanes of bytes
// by hand: they would do what autovec does. No row in one register of its own: the packed engine's
// batch is one already.
constexpr std::array kRows = {
    autovec_variant<Isa::baseline>(),
    autovec_variant<Isa::sse42>(),
    autovec_variant<Isa::avx2>(),
    autovec_variant<Isa::avx512>(),
    autovec_variant<Isa::avx512icl>(),
    scalar(kOneThread),
    scalar(kThreaded),
    packed<Isa::baseline>(kOneThread),
    packed<Isa::baseline>(kThreaded),
    packed<Isa::sse42>(kOneThread),
    packed<Isa::sse42>(kThreaded),
    packed<Isa::avx2>(kOneThread),
    packed<Isa::avx2>(kThreaded),
    packed<Isa::avx512>(kOneThread),
    packed<Isa::avx512>(kThreaded),
    packed<Isa::avx512icl>(kOneThread),
    packed<Isa::avx512icl>(kThreaded),
};

}  // namespace

std::span<const ThinningVariant> scan_rows() {
  return kRows;
}

}  // namespace thinbench::detail
