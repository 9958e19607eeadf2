// What the parts of the command-line program share. Each command declares its arguments and returns
// the function that runs it.
#pragma once

#include <functional>
#include <ostream>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/usage.hpp"

namespace thinbench {

class Verifier;

struct Console {
  std::ostream& out;
  std::ostream& err;
  bool err_is_terminal;
};

struct Command {
  CLI::App* app;
  std::function<int(const Console&)> run;  // after parsing
  std::vector<Command> parts = {};         // of a command that only holds others and has no `run`
};

[[nodiscard]] Command add_list_command(CLI::App& program);
[[nodiscard]] Command add_verify_command(CLI::App& program);
[[nodiscard]] Command add_run_command(CLI::App& program);
[[nodiscard]] Command add_rule_command(CLI::App& program);
[[nodiscard]] Command add_batch_command(CLI::App& program);
[[nodiscard]] Command add_edges_command(CLI::App& program);
[[nodiscard]] Command add_holes_command(CLI::App& program);
[[nodiscard]] Command add_graph_command(CLI::App& program);
[[nodiscard]] Command add_scene_command(CLI::App& program);
[[nodiscard]] Command add_machine_command(CLI::App& program);
[[nodiscard]] Command add_train_command(CLI::App& program);
[[nodiscard]] Command add_experiment_command(CLI::App& program);
[[nodiscard]] Command add_instructions_command(CLI::App& program);
[[nodiscard]] Command add_pictures_command(CLI::App& program);
[[nodiscard]] Command add_circuits_command(CLI::App& program);

/// Skipped rows with the reason, mismatches, and "N passed, M failed, K skipped" as the last line.
/// kFailure where a row differs from its reference, else kSuccess; throws UsageError where no row
/// ran.
int report_verdicts(const Verifier& verifier, std::ostream& out);

}  // namespace thinbench
