// Graphs of skeletons: the commands that find them take the same.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/graph_formats.hpp"
#include "images/image_file.hpp"
#include "support/byte_image.hpp"
#include "thinbench/graph.hpp"

namespace thinbench {

struct GraphRequest {
  std::string thinning = "thin_guo_hall";
  Pruning pruning;
  std::optional<double> open_cycles;  // of cycles up to this length
  std::vector<Pixel> nodes;           // pixels that become nodes
  std::optional<double> tolerance;    // default: the size of a pixel
  bool with_main_paths = false;
  std::string unit;  // of the spacing; empty: unnamed
  int threads = 1;

  [[nodiscard]] bool is_skeleton() const { return thinning == "none"; }
};

/// --thinning, --spacing, --unit, --prune, --prune-widths, --remove-components, --open-cycles,
/// --main-path and --tolerance.
void add_graph_options(CLI::App& app, GraphRequest& request);

/// A hash of the rule's file, as RequestedThinning has it. Throws UsageError where no operation of
/// this name thins.
[[nodiscard]] std::string checked_thinning(const GraphRequest& request);

/// Thinned, unless the request says that it is a skeleton.
[[nodiscard]] ByteImage skeleton_of(const ByteImage& image, const GraphRequest& request);

/// "3 blocks of 2 x 2 pixels, the first at (4, 7)"; empty for thin lines.
[[nodiscard]] std::string thickness_of(const ByteImage& skeleton);

/// Prunes the skeleton. `image` gives the widths.
[[nodiscard]] FoundGraph find_graph(const ByteImage& image, ByteImage& skeleton,
                                    const ImagePage& page, const GraphRequest& request);

/// The same for labels. `objects` give the widths, and are thinned in `skeletons`.
[[nodiscard]] LabelPixels skeletons_of(const LabelPixels& objects, const GraphRequest& request);
[[nodiscard]] FoundGraph find_graphs(const LabelPixels& objects, LabelPixels& skeletons,
                                     const ImagePage& page, const GraphRequest& request);

}  // namespace thinbench
