// Techniques: the ways in which an operation is computed, each with its name and one sentence.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace thinbench {

/// In the order of kTechniques. The list ends with the fastest: the library chooses the last
/// technique of the highest level.
enum class Technique : std::uint8_t {
  lut,
  lut_sliding,
  union_find,
  autovec,
  simd_float_bytes,
  simd_float_bits,
  simd_fixed_point,
  bitpacked,
  bitpacked_runs,
  simd_bytes,
  simd_bitpacked,
  simd_bitpacked_tiles,
  simd_bitpacked_row,
  simd_to_bits,
  simd_16bit,
  simd_8bit,
  simd_runs,
};

struct TechniqueInfo {
  Technique technique;
  std::string_view name;
  std::string_view description;
};

inline constexpr std::array kTechniques = {
    TechniqueInfo{Technique::lut, "lut", "bytes of a neighbourhood gathered, one table"},
    TechniqueInfo{Technique::lut_sliding, "lut_sliding",
                  "descriptor that slides along the row, 4096-entry table"},
    TechniqueInfo{Technique::union_find, "union_find",
                  "two passes over bytes, provisional labels in a union-find forest"},
    TechniqueInfo{Technique::autovec, "autovec",
                  "the reference's arithmetic, vectorised by the compiler"},
    TechniqueInfo{Technique::simd_float_bytes, "simd_float_bytes",
                  "xsimd, the net's sums in single precision, from bytes"},
    TechniqueInfo{Technique::simd_float_bits, "simd_float_bits",
                  "xsimd, the net's sums in single precision, from packed dark pixels"},
    TechniqueInfo{Technique::simd_fixed_point, "simd_fixed_point",
                  "xsimd, the net's sums on 8-bit integers, from packed bits"},
    TechniqueInfo{Technique::bitpacked, "bitpacked", "64 pixels a word, the minimal circuit"},
    TechniqueInfo{Technique::bitpacked_runs, "bitpacked_runs",
                  "runs of packed pixels by count-trailing-zeros, union-find over runs"},
    TechniqueInfo{Technique::simd_bytes, "simd_bytes", "xsimd, one pixel a byte lane"},
    TechniqueInfo{Technique::simd_bitpacked, "simd_bitpacked", "xsimd on packed words, any width"},
    TechniqueInfo{Technique::simd_bitpacked_tiles, "simd_bitpacked_tiles",
                  "xsimd on tiles of 16 x 32 packed pixels, only where something changed"},
    TechniqueInfo{Technique::simd_bitpacked_row, "simd_bitpacked_row",
                  "one row of up to 512 pixels in one AVX-512 register"},
    TechniqueInfo{Technique::simd_to_bits, "simd_to_bits",
                  "the fastest way on lanes of grey levels, result in packed bits"},
    TechniqueInfo{Technique::simd_16bit, "simd_16bit",
                  "gradients in 16-bit lanes, one fused sweep"},
    TechniqueInfo{Technique::simd_8bit, "simd_8bit",
                  "gradients in 8-bit lanes that saturate, where these are exact"},
    TechniqueInfo{Technique::simd_runs, "simd_runs",
                  "xsimd, one run a lane; union-find for runs that change"},
};

consteval bool techniques_stand_in_the_order_of_the_enumeration() {
  for (std::size_t i = 0; i < kTechniques.size(); ++i) {
    if (kTechniques[i].technique != static_cast<Technique>(i)) return false;
  }
  return true;
}
static_assert(techniques_stand_in_the_order_of_the_enumeration(),
              "kTechniques is indexed by Technique");

[[nodiscard]] constexpr const TechniqueInfo& technique_info(Technique technique) {
  return kTechniques[static_cast<std::size_t>(technique)];
}

[[nodiscard]] constexpr std::string_view technique_name(Technique technique) {
  return technique_info(technique).name;
}

[[nodiscard]] constexpr std::optional<Technique> technique_from_name(std::string_view name) {
  for (const TechniqueInfo& info : kTechniques) {
    if (info.name == name) return info.technique;
  }
  return std::nullopt;
}

}  // namespace thinbench
