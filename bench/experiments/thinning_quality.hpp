// How good the skeletons of each operation are: topology, thinness, place, symmetry.
#pragma once

#include <string>
#include <vector>

#include "experiments/report.hpp"
#include "experiments/skeleton_measures.hpp"
#include "images/binarise.hpp"

namespace thinbench {

struct QualityInput {
  std::string name;
  ByteImage image;  // 0 and 255
};

/// The test scene and blobs of smoothed noise; given images follow, binarised with the remarks in
/// `log`, named as their files, each unlike all other inputs and files of skeletons. Throws
/// FileError.
[[nodiscard]] std::vector<QualityInput> quality_inputs(const std::vector<std::string>& images,
                                                       const BinariseOptions& binarise = {},
                                                       std::ostream* log = nullptr);

/// Noise of half the pixels, foreground where most of the 9 x 9 pixels round it are.
[[nodiscard]] ByteImage blobs(Index width, Index height, std::uint64_t seed);

/// The inputs and their skeletons as image files `quality_<input>[_<operation>].png` in a
/// directory.
void write_skeletons(const std::string& directory, const std::vector<QualityInput>& inputs);

/// Every thinning rule that is no net, with zero padding, on every input. `min_symmetry` is the
/// smallest overlap with the skeletons of the rotated input, rotated back.
[[nodiscard]] ExperimentReport thinning_quality(const std::vector<QualityInput>& inputs,
                                                const std::string& options = "");

}  // namespace thinbench
