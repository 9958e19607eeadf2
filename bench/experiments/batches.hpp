// Many small images at once against the same images one by one.
#pragma once

#include <string>
#include <vector>

#include "experiments/report.hpp"
#include "experiments/stroke_images.hpp"

namespace thinbench {

struct BatchesChoice {
  Index images = 10000;
  int rounds = 9;  // at least 3
  int turns = 5;   // of each way in a round, interleaved
  static BatchesChoice quick() { return {2000, 9, 1}; }
};

struct BatchRow {
  std::string operation;
  Index side;
  double foreground;   // share of all pixels
  int iterations;      // the maximum over the images
  std::string single;  // technique and ISA of the fastest variant, one image after another
  std::string isa;     // of the batch
  double single_per_second;
  double batch_per_second;
  double ratio;  // of the two: median over rounds, all but the lowest, all but the highest
  double ratio_low;
  double ratio_high;
};

/// Strokes of 28 x 28 and of 64 x 64 pixels by three operations on one thread. Throws
/// std::runtime_error where an image of a batch is not its reference's.
[[nodiscard]] std::vector<BatchRow> run_batches(const BatchesChoice& choice);

[[nodiscard]] ExperimentReport batches_report(const std::vector<BatchRow>& rows,
                                              const BatchesChoice& choice,
                                              const std::string& options = "");

}  // namespace thinbench
