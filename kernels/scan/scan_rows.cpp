#include "scan/scan_rows.hpp"

#include <array>

namespace thinbench {
namespace {

using enum Technique;

template <Isa isa>
constexpr ThinningVariant packed(bool threaded) {
  return {kSimdBitpacked, isa, threaded, kAnyWidth, &IsaScan<isa>::kSimdBitpacked};
}

template <Isa isa>
constexpr ThinningVariant autovec() {
  return {kAutovec, isa, kOneThread, kAnyWidth, &IsaScan<isa>::kAutovec};
}

constexpr ThinningVariant scalar(bool threaded) {
  return {kBitpacked, Isa::kBaseline, threaded, kAnyWidth, &ScalarScan::kBitpacked};
}

// No look-up table: what makes a centre may lie as far away as the run is long. No lanes of bytes
// by hand: they would do what autovec does. No row in one register of its own: the packed engine's
// batch is one already.
constexpr std::array kRows = {
    autovec<Isa::kBaseline>(),
    autovec<Isa::kSse42>(),
    autovec<Isa::kAvx2>(),
    autovec<Isa::kAvx512>(),
    autovec<Isa::kAvx512Icl>(),
    scalar(kOneThread),
    scalar(kThreaded),
    packed<Isa::kBaseline>(kOneThread),
    packed<Isa::kBaseline>(kThreaded),
    packed<Isa::kSse42>(kOneThread),
    packed<Isa::kSse42>(kThreaded),
    packed<Isa::kAvx2>(kOneThread),
    packed<Isa::kAvx2>(kThreaded),
    packed<Isa::kAvx512>(kOneThread),
    packed<Isa::kAvx512>(kThreaded),
    packed<Isa::kAvx512Icl>(kOneThread),
    packed<Isa::kAvx512Icl>(kThreaded),
};

}  // namespace

std::span<const ThinningVariant> scan_rows() {
  return kRows;
}

}  // namespace thinbench
