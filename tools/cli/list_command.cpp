// thinbench list: the operations on image files.
#include "cli/aligned.hpp"
#include "cli/command.hpp"
#include "cli/thinbench.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {
namespace {

int list(std::ostream& out) {
  std::vector<Cells> lines = {{"operation", "command", "what it does"}};
  const auto add = [&lines](const auto& infos, const char* command) {
    for (const auto& info : infos) {
      lines.push_back({std::string(info.operation), command, std::string(info.description)});
    }
  };
  add(kRules, "run, batch");
  lines.push_back({"midpoint_scan", "run, batch", "midpoints of the runs of foreground pixels"});
  add(kEdgeOperators, "edges, batch");
  lines.push_back({"holes", "holes, batch", "objects and their holes: area, centre, box"});
  lines.push_back({"localise", "localise, batch", "the same from a grey image, by edges"});
  lines.push_back({"fill-holes", "fill-holes", "objects with all that they enclose"});
  lines.push_back({"labels", "labels", "the number of each pixel's object"});
  lines.push_back({"distance", "distance", "the distance of each pixel to the background"});
  lines.push_back({"euler", "euler", "objects minus holes"});
  lines.push_back({"graph", "graph, batch", "ends, junctions, branches and widths of a skeleton"});
  lines.push_back({"path", "path", "a path for a robot through a map"});
  print_aligned(lines, out);
  return kSuccess;
}

}  // namespace

Command add_list_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("list", "List the operations");
  app->footer(R"(Examples:
  thinbench list

A line for each operation, with the commands that take it. Named rules of 3 x 3 pixels are listed by
'thinbench rule --list'.)");
  return {app, [](const Console& console) { return list(console.out); }};
}

}  // namespace thinbench
