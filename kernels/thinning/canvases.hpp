// Canvases: small images on which other images or labels are drawn to be thinned. They have few
// sizes, so that they are thinned as stacks.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/thread_team.hpp"
#include "thinbench/image_view.hpp"
#include "thinning/operations.hpp"

namespace thinbench::detail {

/// The sides of a canvas for a width and a height: the next of few sizes, which suit the lanes.
[[nodiscard]] Index canvas_width(Index width);
[[nodiscard]] Index canvas_height(Index height);

/// What is drawn on a canvas is known by its number.
struct Canvas {
  Index width;
  Index height;
  std::size_t item;
};

/// Sorts by size, largest first; those of one size keep their order.
void sort_by_size(std::vector<Canvas>& canvases);

/// The end of the canvases of the first one's size, of canvases sorted by size. Not for an empty
/// range.
[[nodiscard]] const Canvas* end_of_size(const Canvas* first, const Canvas* last);

/// Draws an item on a canvas of zeros, and takes its skeleton from there (0 and 255). Threads call
/// both at once for different items.
struct CanvasPainter {
  std::function<void(std::size_t item, const ImageView& canvas)> draw;
  std::function<void(std::size_t item, const ConstImageView& canvas)> take;
};

/// Thins all canvases and returns the maximum number of iterations, 0 without canvases. The threads
/// of the team share the work. Takes 256 KiB per thread, or a canvas if that is larger. Checks
/// nothing: the call must be valid for the widest canvas.
[[nodiscard]] int thin_canvases(const ThinningCall& call, std::vector<Canvas> canvases,
                                const CanvasPainter& painter, const ThreadTeam& team);

}  // namespace thinbench::detail
