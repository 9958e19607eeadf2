// Options of operations: technique, ISA, threads, border and others.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>

#include "thinbench/enumeration.hpp"
#include "thinbench/isa.hpp"

namespace thinbench {

/// How an operation treats the image border. Everything outside the image is background unless it
/// says otherwise.
enum class Border : std::uint8_t {
  background,  // the outermost pixels are thinned like all others
  keep,        // the outermost rows and columns never change, as in OpenCV
  foreground,  // custom rules only: everything outside the image is foreground
};

inline constexpr std::array<std::string_view, 3> kBorderNames = {"background", "keep",
                                                                 "foreground"};

/// Throws std::invalid_argument for a value outside the enumeration.
[[nodiscard]] constexpr std::string_view border_name(Border border) {
  return detail::entry_of(kBorderNames, border, "border");
}

/// An algorithm for an operation. All techniques of an operation give the same result.
enum class Technique : std::uint8_t {
  lut,
  lut_sliding,
  union_find,
  autovec,
  simd_float_bits,
  simd_fixed_point,
  bitpacked,
  bitpacked_runs,
  simd_bytes,
  simd_bitpacked,
  simd_bitpacked_tiles,
  simd_bitpacked_row,
  simd_16bit,
  simd_8bit,
  simd_runs,
  envelope,
  simd_32bit,
};

struct TechniqueInfo {
  Technique technique;
  std::string_view name;
  std::string_view description;
};

/// All techniques, in the order of the enumeration.
inline constexpr std::array kTechniques = {
    TechniqueInfo{Technique::lut, "lut", "neighbourhoods gathered from bytes, one look-up table"},
    TechniqueInfo{Technique::lut_sliding, "lut_sliding",
                  "neighbourhoods that slide along the row, 4096-entry table"},
    TechniqueInfo{Technique::union_find, "union_find",
                  "two-pass labelling of bytes, provisional labels in a union-find forest"},
    TechniqueInfo{Technique::autovec, "autovec",
                  "the reference's arithmetic, vectorised by the compiler"},
    TechniqueInfo{Technique::simd_float_bits, "simd_float_bits",
                  "xsimd, the net's sums in single precision, from packed pixels"},
    TechniqueInfo{Technique::simd_fixed_point, "simd_fixed_point",
                  "xsimd, the net's sums on 8-bit integers, from packed pixels"},
    TechniqueInfo{Technique::bitpacked, "bitpacked", "64 pixels per word, the minimal circuit"},
    TechniqueInfo{Technique::bitpacked_runs, "bitpacked_runs",
                  "runs of packed pixels by count-trailing-zeros, union-find over runs"},
    TechniqueInfo{Technique::simd_bytes, "simd_bytes", "xsimd, one pixel per byte lane"},
    TechniqueInfo{Technique::simd_bitpacked, "simd_bitpacked", "xsimd on packed words, any width"},
    TechniqueInfo{Technique::simd_bitpacked_tiles, "simd_bitpacked_tiles",
                  "xsimd on tiles of 16 x 32 packed pixels, only where something changed"},
    TechniqueInfo{Technique::simd_bitpacked_row, "simd_bitpacked_row",
                  "one row of up to 512 pixels in one AVX-512 register"},
    TechniqueInfo{Technique::simd_16bit, "simd_16bit",
                  "gradients in 16-bit lanes, one fused scan of the image"},
    TechniqueInfo{Technique::simd_8bit, "simd_8bit",
                  "gradients in saturating 8-bit lanes, where these are exact"},
    TechniqueInfo{Technique::simd_runs, "simd_runs",
                  "xsimd, one run per lane; union-find for runs that change"},
    TechniqueInfo{Technique::envelope, "envelope",
                  "the lower envelope of parabolas, in time linear in the width"},
    TechniqueInfo{Technique::simd_32bit, "simd_32bit",
                  "xsimd, distances in 32-bit lanes, searched as far as needed"},
};

/// This and technique_name throw std::invalid_argument for a value outside the enumeration.
[[nodiscard]] constexpr const TechniqueInfo& technique_info(Technique technique) {
  return detail::entry_of(kTechniques, technique, "technique");
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

/// A direction in which the midpoint scan finds runs of foreground pixels.
enum class Direction : std::uint8_t {
  rows,           // west to east
  columns,        // north to south
  diagonals,      // north-west to south-east
  antidiagonals,  // north-east to south-west
};

inline constexpr std::array kAllDirections = {Direction::rows, Direction::columns,
                                              Direction::diagonals, Direction::antidiagonals};
inline constexpr int kDirectionCount = 4;
inline constexpr std::array<std::string_view, kDirectionCount> kDirectionNames = {
    "rows", "columns", "diagonals", "antidiagonals"};

/// A set of directions; bit i stands for static_cast<Direction>(i). Default: all.
struct Directions {
  std::uint8_t bits = (1 << kDirectionCount) - 1;

  [[nodiscard]] constexpr bool has(Direction direction) const {
    return (bits >> static_cast<int>(direction) & 1) != 0;
  }
  constexpr void add(Direction direction) {
    bits = static_cast<std::uint8_t>(bits | 1 << static_cast<int>(direction));
  }
  friend constexpr bool operator==(Directions, Directions) = default;
};

inline constexpr Directions kNoDirections = {0};

/// Opaque; created by the functions of thinbench/nets.hpp.
struct NetModel;

inline constexpr int kUnlimited = std::numeric_limits<int>::max();
inline constexpr int kMaxThreads = 1024;

/// Options of one call. Operations reject options that do not apply to them.
struct Options {
  /// Thinning only.
  Border border = Border::background;
  /// Thinning only: the maximum number of iterations, at least 1. An iteration applies every
  /// sub-iteration of the rule once.
  int max_iterations = kUnlimited;
  /// The maximum number of threads, from 1 to kMaxThreads. If no technique is set, images below
  /// 2^20 pixels use one thread, which is faster.
  int threads = 1;
  /// Default: the fastest that this machine supports.
  std::optional<Isa> isa = std::nullopt;
  std::optional<Technique> technique = std::nullopt;
  /// The midpoint scan only.
  Directions directions = {};
  /// Nets only; nullptr: the rule's default weights.
  std::shared_ptr<const NetModel> net = nullptr;
};

}  // namespace thinbench
