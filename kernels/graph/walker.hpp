// Nodes and edges from node pixels and line pixels.
#pragma once

#include <vector>

#include "core/byte_image.hpp"
#include "thinbench/graph.hpp"

namespace thinbench::detail {

/// 1 + the node of every node pixel; other pixels have no value.
struct NodeMap {
  std::uint32_t* data;
  Index width;

  std::uint32_t& operator[](Pixel p) const { return data[p.y * width + p.x]; }
};

/// Walks along lines pixel by pixel. Cost per line pixel: three bits from each of three rows, a
/// look-up of the joined neighbours, and the pixel's entry in the list.
class GraphWalker {
 public:
  GraphWalker(Index width, Index height);

  /// `lines` becomes empty. The planes have the size given before. Valid until the next call; may
  /// be moved from.
  Graph& walk(const ConstBitPlaneView& image, const ConstBitPlaneView& nodes,
              const BitPlaneView& lines);

  [[nodiscard]] NodeMap node_at() { return {node_at_.get(), width_}; }

 private:
  class Walk;

  Index width_;
  AlignedArray<std::uint32_t> node_at_;
  std::vector<Pixel> to_visit_;
  Graph graph_;
};

}  // namespace thinbench::detail
