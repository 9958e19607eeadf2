// Edges of each operator against the true contours of the scene.
#include <algorithm>
#include <cstdint>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/distances.hpp"
#include "experiments/experiments.hpp"
#include "scene/scene.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kPrattScale = 9;
constexpr std::int64_t kNearSquared = 2;  // one pixel away, diagonals included

struct Matches {
  double near = 0;
  double merit = 0;
  double all = 0;
};

/// How the marked pixels lie to those that `distances` were measured from.
Matches match(const ConstImageView& marked, const Distances& distances) {
  Matches matches;
  for (Index y = 0; y < marked.height; ++y) {
    for (Index x = 0; x < marked.width; ++x) {
      if (marked.row(y)[x] == 0) continue;
      const std::int64_t squared = distances.squared(x, y);
      matches.all += 1;
      matches.near += squared <= kNearSquared ? 1 : 0;
      matches.merit += 1 / (1 + static_cast<double>(squared) / kPrattScale);
    }
  }
  return matches;
}

double share(double part, double all) {
  return all > 0 ? part / all : 1;
}

ByteImage edges_of(EdgeOperator op, const ConstImageView& grey, const EdgeThresholds& thresholds) {
  ByteImage edges(grey.width, grey.height);
  detect_edges(op, grey, edges.view(), thresholds);
  return edges;
}

/// `first_seed` and those after it, as the scene's own noise counts them.
Scene noisy_scene(int sigma, int seed) {
  SceneOptions options;
  options.noise_sigma_16 = 16 * sigma;
  options.seed += static_cast<std::uint64_t>(seed);
  return render_scene(options);
}

/// Means over the scenes.
Json measure(const EdgeOperatorInfo& info, int sigma, const EdgeThresholds& thresholds,
             const std::vector<Scene>& scenes, const TrueContours& contours) {
  EdgeQuality mean = {0, 0, 0, 0};
  double precision_without_p2 = 0;
  const double weight = 1.0 / static_cast<double>(scenes.size());
  for (const Scene& scene : scenes) {
    const ByteImage edges = edges_of(info.op, scene.grey.view(), thresholds);
    const EdgeQuality one = quality_of(contours, edges.view());
    mean.precision += weight * one.precision;
    mean.recall += weight * one.recall;
    mean.figure_of_merit += weight * one.figure_of_merit;
    mean.marked += weight * one.marked;
    const ByteImage more = edges_of(info.op, scene.grey.view(), {thresholds.gradient_threshold, 0});
    precision_without_p2 += weight * quality_of(contours, more.view()).precision;
  }
  return {{"operation", info.operation},
          {"border", ""},
          {"max_iterations", nullptr},
          {"sigma", sigma},
          {"precision", mean.precision},
          {"recall", mean.recall},
          {"figure_of_merit", mean.figure_of_merit},
          {"marked", mean.marked},
          {"precision_without_p2", precision_without_p2}};
}

}  // namespace

TrueContours true_contours(const ConstImageView& binary) {
  const auto differs = [&](Index x, Index y, Index other_x, Index other_y) {
    const bool inside =
        other_x >= 0 && other_y >= 0 && other_x < binary.width && other_y < binary.height;
    return inside && binary.row(y)[x] != binary.row(other_y)[other_x];
  };
  const auto is_contour = [&](Index x, Index y) {
    return differs(x, y, x - 1, y) || differs(x, y, x + 1, y) || differs(x, y, x, y - 1) ||
           differs(x, y, x, y + 1);
  };
  const auto pixels = [&](const auto& is_marked) {
    return image_by(binary.width, binary.height,
                    [&](Index x, Index y) { return is_marked(x, y) ? 255 : 0; });
  };
  return {pixels(is_contour),
          pixels([&](Index x, Index y) { return binary.row(y)[x] != 0 && is_contour(x, y); })};
}

EdgeQuality quality_of(const TrueContours& contours, const ConstImageView& edges) {
  const Distances to_edges(edges);
  const Matches edge_pixels = match(edges, Distances(contours.both_sides.view()));
  const Matches contour_pixels = match(contours.both_sides.view(), to_edges);
  const Matches to_inner = match(edges, Distances(contours.inner.view()));
  const double inner_pixels = match(contours.inner.view(), to_edges).all;
  return {share(edge_pixels.near, edge_pixels.all), share(contour_pixels.near, contour_pixels.all),
          share(to_inner.merit, std::max(to_inner.all, inner_pixels)),
          edge_pixels.all / static_cast<double>(std::max<Index>(1, edges.width * edges.height))};
}

ExperimentReport edge_quality(const EdgeQualityChoice& choice) {
  const TrueContours contours = true_contours(noisy_scene(0, 0).binary.view());
  const auto [gradient_threshold, brightness_threshold] = choice.thresholds;
  Json rows = Json::array();
  for (const int sigma : choice.sigmas) {
    std::vector<Scene> scenes;
    scenes.reserve(static_cast<std::size_t>(choice.seeds));
    for (int seed = 0; seed < choice.seeds; ++seed) scenes.push_back(noisy_scene(sigma, seed));
    for (const EdgeOperatorInfo& info : kEdgeOperators) {
      rows.push_back(measure(info, sigma, choice.thresholds, scenes, contours));
    }
  }
  return report_of(
      "edge-quality",
      fmt::format(
          "Edges with P1 {} and P2 {} against the true contours of the scene; a pixel beside "
          "is near enough, so where much is marked, much is found by chance:",
          gradient_threshold, brightness_threshold),
      {{"gradient_threshold", gradient_threshold},
       {"brightness_threshold", brightness_threshold},
       {"seeds", choice.seeds},
       {"rows", rows}},
      choice.options);
}

}  // namespace thinbench
