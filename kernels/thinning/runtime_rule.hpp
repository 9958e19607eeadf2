// Rules that are known at run time only: plain data, for files of every ISA.
#pragma once

#include <cstdint>

namespace thinbench::detail {

inline constexpr int kNeighbours = 8;

/// A node of a decision diagram: value `high` where neighbour n_variable is foreground, else value
/// `low`. Values 0 and 1 are background and foreground, value i + 2 is that of node i.
struct MuxNode {
  std::uint8_t variable;
  std::uint8_t high;
  std::uint8_t low;
};

/// A truth table over the eight neighbours as a reduced ordered decision diagram; the last value is
/// the result. With eight variables no order needs more than 79 nodes.
struct MuxProgram {
  static constexpr int kMaxNodes = 79;
  int count;
  MuxNode nodes[kMaxNodes];
};

/// The diagram of `table`, the result by descriptor. No node reads a later one.
[[nodiscard]] MuxProgram make_mux_program(const std::uint8_t* table);

/// A rule of one sub-iteration over eight neighbours.
struct RuntimeRule {
  std::uint8_t new_pixel[512];      // by k + 256 p, k being the descriptor; 0 or 1
  std::uint16_t pixel_pairs[4096];  // the same for windows of four columns, see pair_table.hpp
  MuxProgram program;               // new_pixel[256 ... 511]
};

}  // namespace thinbench::detail
