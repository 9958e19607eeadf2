// The experiments: claims of the paper about its methods, measured again. All are deterministic.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/report.hpp"
#include "support/byte_image.hpp"
#include "thinbench/edges.hpp"
#include "training/two_layer.hpp"

namespace thinbench {

/// "Integer approximation of weights and biases ... reduces recognition rate" (section 5): Table 1
/// with 0 to 8 fractional bits, rounded, then truncated.
[[nodiscard]] ExperimentReport quantisation();

enum class Quantisation {
  round,     // to the nearest multiple of 2^-bits, halves away from zero
  truncate,  // towards zero
};

/// All weights and biases as multiples of 2^-bits.
[[nodiscard]] HiddenLayerNet quantised(const HiddenLayerNet& net, Quantisation way, int bits);

/// "A cluster of 12 single layer neural networks" (section 3.3): the rule's cluster, trained again,
/// with as few nets as possible, since each run is as long as it can be and a part of a separable
/// run is separable.
[[nodiscard]] ExperimentReport cluster_runs();

struct HiddenNeuronsChoice {
  int min_hidden = 2;
  int max_hidden = 12;
  int seeds = 20;         // 1, 2, ... this many; one start each
  int max_epochs = 2000;  // of each start
  std::string options;    // of the command that chose so

  /// What `--quick` runs: enough to see that it works.
  static HiddenNeuronsChoice quick() { return {2, 12, 3, 1000, " --quick"}; }
};

/// "Successive tests have shown that a number of eight hidden neurones is optimal" (section 3.2).
/// `progress` is called before each number of hidden neurons with the share that is done, 0 to 1.
[[nodiscard]] ExperimentReport hidden_neurons(const HiddenNeuronsChoice& choice,
                                              const std::function<void(double)>& progress);

/// "A clue indicating the speed is the number of operations" (section 4): counted per foreground
/// pixel by running each method on counting types, and again after compilation to a circuit.
[[nodiscard]] ExperimentReport operation_counts();

/// "Hole detection and localisation" (section 2.2): on which images the count of the relabelling
/// scan, as published, is correct. Plates with 0 to 40 holes, by the thickness of their walls;
/// several objects; the scene; and more contours than there are grey levels.
[[nodiscard]] ExperimentReport literal_holes();

struct EdgeQualityChoice {
  std::vector<int> sigmas = {0, 2, 4, 8, 12, 16, 24, 32};  // grey levels
  int seeds = 3;                                           // of the noise
  EdgeThresholds thresholds = {};
  std::string options = {};  // of the command that chose so

  [[nodiscard]] static EdgeQualityChoice quick() { return {{0, 8, 16, 32}, 1, {}, " --quick"}; }
};

/// "This procedure assures reliable edge detection with strong rejection of false edges" (section
/// 2.1): edges of each operator against the true contours of the scene, with growing noise.
[[nodiscard]] ExperimentReport edge_quality(const EdgeQualityChoice& choice = {});

/// How well some edges match the true contours. All rates are from 0 to 1.
struct EdgeQuality {
  double precision = 1;        // edge pixels with a contour pixel at most one pixel away
  double recall = 1;           // contour pixels with an edge pixel at most one pixel away
  double figure_of_merit = 1;  // Pratt's: mean of 1 / (1 + d^2 / 9) over the larger of both sets
  double marked = 0;           // edge pixels of all pixels
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
[[nodiscard]] EdgeQuality quality_of(const TrueContours& contours, const ConstImageView& edges);

}  // namespace thinbench
