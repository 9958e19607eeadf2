// The program `thinbench` and its commands.
#pragma once

#include "cli/program.hpp"

namespace thinbench {

[[nodiscard]] const ProgramInfo& thinbench_program();

[[nodiscard]] Command add_list_command(CLI::App& program);
[[nodiscard]] Command add_run_command(CLI::App& program);
[[nodiscard]] Command add_rule_command(CLI::App& program);
[[nodiscard]] Command add_batch_command(CLI::App& program);
[[nodiscard]] Command add_edges_command(CLI::App& program);
[[nodiscard]] Command add_holes_command(CLI::App& program);
[[nodiscard]] Command add_localise_command(CLI::App& program);
[[nodiscard]] Command add_fill_holes_command(CLI::App& program);
[[nodiscard]] Command add_labels_command(CLI::App& program);
[[nodiscard]] Command add_distance_command(CLI::App& program);
[[nodiscard]] Command add_euler_command(CLI::App& program);
[[nodiscard]] Command add_graph_command(CLI::App& program);
[[nodiscard]] Command add_path_command(CLI::App& program);

}  // namespace thinbench
