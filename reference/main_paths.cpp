#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "graph.hpp"

namespace thinbench::reference {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Between all pixels of a skeleton, as a graph of them: Floyd and Warshall.
class PixelDistances {
 public:
  PixelDistances(ConstImageView image, const Graph& graph, const Spacing& spacing)
      : image_(image), pixels_(graph.node_pixels) {
    pixels_.insert(pixels_.end(), graph.edge_pixels.begin(), graph.edge_pixels.end());
    distances_.assign(pixels_.size() * pixels_.size(), kFar);
    for (std::size_t a = 0; a < pixels_.size(); ++a) {
      for (std::size_t b = 0; b < pixels_.size(); ++b) {
        if (are_joined(pixels_[a], pixels_[b])) at(a, b) = step(pixels_[a], pixels_[b], spacing);
      }
      at(a, a) = 0;
    }
    for (const GraphNode& node : graph.nodes) {
      for (std::size_t a = node.first_pixel; a < node.first_pixel + node.pixel_count; ++a) {
        for (std::size_t b = node.first_pixel; b < node.first_pixel + node.pixel_count; ++b) {
          if (are_joined(pixels_[a], pixels_[b])) at(a, b) = 0;
        }
      }
    }
    for (std::size_t by = 0; by < pixels_.size(); ++by) {
      for (std::size_t a = 0; a < pixels_.size(); ++a) {
        for (std::size_t b = 0; b < pixels_.size(); ++b) {
          at(a, b) = std::min(at(a, b), at(a, by) + at(by, b));
        }
      }
    }
  }

  double& at(std::size_t a, std::size_t b) { return distances_[a * pixels_.size() + b]; }

 private:
  [[nodiscard]] bool foreground(Pixel p) const { return image_.row(p.y)[p.x] != 0; }

  [[nodiscard]] bool are_joined(Pixel a, Pixel b) const {
    const int across = std::abs(a.x - b.x), down = std::abs(a.y - b.y);
    if (across + down == 1) return true;
    return across == 1 && down == 1 && !foreground({a.x, b.y}) && !foreground({b.x, a.y});
  }

  static double step(Pixel a, Pixel b, const Spacing& spacing) {
    return std::hypot((a.x - b.x) * spacing.x, (a.y - b.y) * spacing.y);
  }

  ConstImageView image_;
  std::vector<Pixel> pixels_;
  std::vector<double> distances_;
};

}  // namespace

std::vector<MainPath> main_paths(ConstImageView skeleton, const Spacing& spacing) {
  const Graph graph = reference::skeleton_graph(skeleton);
  PixelDistances distances(skeleton, graph, spacing);
  std::vector<std::size_t> points;  // the pixels that stand for them
  for (const GraphNode& node : graph.nodes) points.push_back(node.first_pixel);
  for (std::size_t i = 0; i < graph.edge_pixels.size(); ++i) {
    points.push_back(graph.node_pixels.size() + i);
  }
  std::vector<MainPath> paths;
  std::vector<bool> is_done(points.size());
  for (std::size_t node = 0; node < graph.nodes.size(); ++node) {
    if (is_done[node]) continue;
    std::vector<std::size_t> component;
    for (std::size_t point = 0; point < points.size(); ++point) {
      if (distances.at(points[node], points[point]) == kFar) continue;
      component.push_back(point);
      is_done[point] = true;
    }
    const auto between = [&](std::size_t a, std::size_t b) {
      return distances.at(points[a], points[b]);
    };
    double longest = 0;
    for (const std::size_t a : component) {
      for (const std::size_t b : component) longest = std::max(longest, between(a, b));
    }
    const auto is_longest = [&](std::size_t a, std::size_t b) {
      return between(a, b) >= longest * (1 - 1e-12);
    };
    for (const std::size_t a : component) {
      const auto b =
          std::ranges::find_if(component, [&](std::size_t other) { return is_longest(a, other); });
      if (b == component.end()) continue;
      paths.push_back({longest, a, *b});
      break;
    }
  }
  return paths;
}

}  // namespace thinbench::reference
