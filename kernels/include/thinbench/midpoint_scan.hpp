// The midpoint scan: a set of pixels in the middle of what is foreground.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "thinbench/export.h"
#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"

namespace thinbench {

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

/// The paper's own method: marks the midpoint of every run of foreground pixels along each
/// direction; of the two middle pixels of an even run, the first in scan order. Lines one pixel
/// wide are kept, and at least one pixel of every 8-component. In general the result is neither
/// connected nor thin.
///
/// The destination is 255 on marks and 0 elsewhere. It may be the source. Everything outside is
/// background; Border::keep also copies the outermost rows and columns. Throws
/// std::invalid_argument.
THINBENCH_API void midpoint_scan(ConstImageView source, ImageView destination,
                                 Directions directions = {}, Border border = Border::background,
                                 const Execution& execution = {});

}  // namespace thinbench
