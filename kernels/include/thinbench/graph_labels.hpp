// The graphs of many skeletons that share an image, each with its own label.
#pragma once

#include <cstdint>
#include <vector>

#include "thinbench/distance.hpp"
#include "thinbench/export.h"
#include "thinbench/graph.hpp"
#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"

namespace thinbench {

/// The graphs of all labels, in the order of the labels; an edge has the label of its nodes.
struct LabelGraph {
  Graph graph;
  std::vector<std::int32_t> labels;  // of the nodes

  friend bool operator==(const LabelGraph&, const LabelGraph&) = default;
};

/// skeleton_graph() of the pixels of each label, one after another. Pixels with different labels
/// are never joined, even where they touch. 0 is background; labels may be any other numbers, and a
/// label may have several components. thin_labels() makes such images.
///
/// Where labels touch, the image is searched several times, as a rule two to five, and takes 4 more
/// bytes of memory per pixel. Thread-safe. Throws as skeleton_graph does.
[[nodiscard]] THINBENCH_API LabelGraph graph_of_labels(ConstLabelView skeletons,
                                                       const Execution& execution = {});

/// distances() from each pixel of a label to the nearest pixel that does not have this label, in
/// the unit of the spacing; 0 on background, infinity if one label covers the image.
///
/// Memory as graph_of_labels, and 8 bytes per pixel more where labels touch. Thread-safe for
/// different destinations. Throws as distances() does; then nothing is written, except if memory
/// runs out.
THINBENCH_API void distances_of_labels(ConstLabelView labels, View<double> distances,
                                       const Spacing& spacing = {},
                                       const Execution& execution = {});

/// prune() for the skeleton of each label as if it were alone in the image: pixels that are removed
/// become 0. `pruning.distances` are distances_of_labels() of what was thinned. Returns the graphs
/// of the result.
///
/// Views must have the same size and be the same image or share no pixel. Memory as
/// graph_of_labels. Throws as prune() does; then nothing is written, except if memory runs out.
THINBENCH_API LabelGraph prune_labels(ConstLabelView skeletons, LabelView destination,
                                      const Pruning& pruning, const Execution& execution = {});

}  // namespace thinbench
