// The directions in which an image is scanned for runs of dark pixels.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace thinbench::detail {

enum class Direction : std::uint8_t {
  rows,           // west to east
  columns,        // north to south
  diagonals,      // north-west to south-east
  antidiagonals,  // north-east to south-west
};

inline constexpr int kDirectionCount = 4;

inline constexpr std::array kAllDirections = {Direction::rows, Direction::columns,
                                              Direction::diagonals, Direction::antidiagonals};

inline constexpr std::array<std::string_view, kDirectionCount> kDirectionNames = {
    "rows", "columns", "diagonals", "antidiagonals"};

/// A set of directions: bit i stands for the direction of this number.
struct Directions {
  std::uint8_t bits = (1 << kDirectionCount) - 1;

  [[nodiscard]] constexpr bool has(Direction direction) const {
    return (bits >> static_cast<int>(direction) & 1) != 0;
  }
  constexpr void add(Direction direction) {
    bits = static_cast<std::uint8_t>(bits | 1 << static_cast<int>(direction));
  }
};

inline constexpr Directions kNoDirections = {0};

}  // namespace thinbench::detail
