#include "cli/thinbench.hpp"

namespace thinbench {

const ProgramInfo& thinbench_program() {
  static const ProgramInfo program = {
      "thinbench",
      "Thinning, edges, holes and graphs of image files",
      R"(Examples:
  thinbench list
  thinbench run thin_naccache_shinghal parts.png skeleton.png
  thinbench run majority parts.png smooth.png
  thinbench batch thin_guo_hall scans --out skeletons
  thinbench edges parts.png edges.png --operator sobel
  thinbench holes parts.png --foreground dark --min-area 20 --overlay found.png
  thinbench graph roads.png --prune 10 --overlay roads.svg

Commands that read images agree on which pixels are foreground: by default the class, of two found by
Otsu's method, that covers less of the image border; else what --foreground and --threshold say.
THINBENCH_MAX_ISA=avx2 (or baseline, sse4.2, avx512, avx512icl) caps the instruction set.)",
      {&add_list_command, &add_run_command, &add_rule_command, &add_batch_command,
       &add_edges_command, &add_holes_command, &add_localise_command, &add_fill_holes_command,
       &add_labels_command, &add_distance_command, &add_euler_command, &add_graph_command,
       &add_path_command}};
  return program;
}

}  // namespace thinbench
