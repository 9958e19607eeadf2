// "This procedure assures reliable edge detection with strong rejection of false edges" (section
// 2.1): edges of each operator against the true contours of the scene, with growing noise.
#pragma once

#include <string>
#include <vector>

#include "experiments/report.hpp"
#include "support/byte_image.hpp"
#include "thinbench/edges.hpp"

namespace thinbench {

struct EdgeQualityChoice {
  std::vector<int> sigmas = {0, 2, 4, 8, 12, 16, 24, 32};  // grey levels
  int seeds = 3;                                           // of the noise
  EdgeThresholds thresholds = {};

  [[nodiscard]] static EdgeQualityChoice quick() { return {{0, 8, 16, 32}, 1, {}}; }
};

/// How well some edges match the true contours. All rates are from 0 to 1.
struct EdgeQuality {
  double precision = 1;        // edge pixels with a contour pixel at most one pixel away
  double recall = 1;           // contour pixels with an edge pixel at most one pixel away
  double figure_of_merit = 1;  // Pratt's: mean of 1 / (1 + d^2 / 9) over the larger of both sets
  double marked = 0;           // edge pixels of all pixels
};

struct EdgeQualityRow {
  std::string operation;
  int sigma;
  EdgeQuality quality;          // means over the seeds
  double precision_without_p2;  // the same with P2, the brightness threshold, 0
};

/// The contours of a binary image, both 255 on 0.
struct TrueContours {
  ByteImage both_sides;  // pixels with one of the four neighbours of the other kind
  ByteImage inner;       // those of objects: one pixel wide
};
[[nodiscard]] TrueContours true_contours(const ConstImageView& binary);

/// Compares edges, 255 on 0, with contours. Precision and recall take either side of a border as
/// correct. Pratt's figure wants contours one pixel wide: with both sides it would ask for edges
/// two pixels wide; so edges that are lose by their second pixel.
[[nodiscard]] EdgeQuality edge_quality(const TrueContours& contours, const ConstImageView& edges);

/// Every operator at every noise.
[[nodiscard]] std::vector<EdgeQualityRow> run_edge_quality(const EdgeQualityChoice& choice);

[[nodiscard]] ExperimentReport edge_quality_report(const std::vector<EdgeQualityRow>& rows,
                                                   const EdgeQualityChoice& choice,
                                                   const std::string& options = "");

}  // namespace thinbench
