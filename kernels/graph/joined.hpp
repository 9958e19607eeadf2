// How the pixels of a skeleton are joined: see thinbench/graph.hpp.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "core/plane_view.hpp"
#include "thinbench/graph.hpp"

namespace thinbench::detail {

// Directions are numbered clockwise from the east; a set of them has bit d for direction d.
inline constexpr int kDirections = 8;
inline constexpr std::array<Pixel, kDirections> kSteps = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
using DirectionSet = unsigned;

constexpr bool is_diagonal(int direction) {
  return direction % 2 == 1;
}

constexpr int opposite(int direction) {
  return (direction + kDirections / 2) % kDirections;
}

constexpr void add_step(Steps& steps, int direction) {
  ++(is_diagonal(direction) ? steps.diagonal
     : direction % 4 == 0   ? steps.horizontal
                            : steps.vertical);
}

constexpr Pixel moved(Pixel p, int direction) {
  const Pixel step = kSteps[static_cast<std::size_t>(direction)];
  return {p.x + step.x, p.y + step.y};
}

template <class Body>
void for_directions(DirectionSet set, const Body& body) {
  for (; set != 0; set &= set - 1) body(std::countr_zero(set));
}

/// Where the window's bits of the eight neighbours are: three bits of the row above, three of the
/// row below, west and east.
inline constexpr std::array<int, kDirections> kWindowBits = {7, 5, 4, 3, 6, 0, 1, 2};

constexpr bool has_neighbour(unsigned window, int direction) {
  return (window >> kWindowBits[static_cast<std::size_t>(direction % kDirections)] & 1) != 0;
}

consteval auto joined_table() {
  std::array<std::uint8_t, 256> table{};
  for (unsigned window = 0; window < table.size(); ++window) {
    for (int d = 0; d < kDirections; ++d) {
      const bool has_way_round = is_diagonal(d) && (has_neighbour(window, d + 1) ||
                                                    has_neighbour(window, d + kDirections - 1));
      if (has_neighbour(window, d) && !has_way_round) {
        table[window] |= static_cast<std::uint8_t>(1U << d);
      }
    }
  }
  return table;
}

/// Whether the pixel of a window is the first of a full block: east, south-east and south.
constexpr bool begins_block(unsigned window, int east = 0) {
  return has_neighbour(window, east) && has_neighbour(window, east + 1) &&
         has_neighbour(window, east + 2);
}

inline constexpr auto kJoined = joined_table();

consteval auto line_table() {
  std::array<bool, 256> table{};
  for (unsigned window = 0; window < table.size(); ++window) {
    bool in_block = false;
    for (int d = 0; d < kDirections; d += 2) in_block = in_block || begins_block(window, d);
    table[window] = std::popcount(kJoined[window]) == 2 && !in_block;
  }
  return table;
}

inline constexpr auto kIsLine = line_table();

inline bool bit_at(const ConstBitPlaneView& plane, Pixel p) {
  return (plane.row(p.y)[p.x >> 6] >> (p.x & 63) & 1) != 0;
}

inline void clear_bit(const BitPlaneView& plane, Pixel p) {
  plane.row(p.y)[p.x >> 6] &= ~(std::uint64_t{1} << (p.x & 63));
}

/// Bits x - 1 to x + 1 of a row.
inline unsigned three_bits(const std::uint64_t* row, Index x) {
  const Index first = x - 1;
  const std::uint64_t* const words = row + (first >> 6);
  const auto shift = static_cast<unsigned>(first & 63);
  return static_cast<unsigned>(words[0] >> shift | words[1] << 1 << (63 - shift)) & 7;
}

/// The eight neighbours of a pixel.
inline unsigned window_at(const ConstBitPlaneView& image, Pixel p) {
  const unsigned above = three_bits(image.row(p.y - 1), p.x);
  const unsigned here = three_bits(image.row(p.y), p.x);
  const unsigned below = three_bits(image.row(p.y + 1), p.x);
  return above | below << 3 | (here & 1) << 6 | (here >> 2) << 7;
}

/// The only direction of a line pixel beside the one that leads back.
inline int direction_on(unsigned window, int direction) {
  return std::countr_zero(kJoined[window] & ~(1U << opposite(direction)));
}

}  // namespace thinbench::detail
