// The program `thinbench-study` and its commands: what verifies and measures the library.
#pragma once

#include <initializer_list>
#include <ostream>
#include <string>

#include "cli/program.hpp"

namespace thinbench {

class Verifier;

[[nodiscard]] const ProgramInfo& study_program();

[[nodiscard]] Command add_study_list_command(CLI::App& program);
[[nodiscard]] Command add_study_run_command(CLI::App& program);
[[nodiscard]] Command add_verify_command(CLI::App& program);
[[nodiscard]] Command add_circuits_command(CLI::App& program);
[[nodiscard]] Command add_scene_command(CLI::App& program);
[[nodiscard]] Command add_train_command(CLI::App& program);
[[nodiscard]] Command add_experiment_command(CLI::App& program);
[[nodiscard]] Command add_instructions_command(CLI::App& program);

/// Rejects files that could not be written, before the work; "" is no file.
void check_targets(std::initializer_list<std::string> paths);

/// With a line in `err`; "" is no file.
void write_if_named(const std::string& path, const std::string& text, std::ostream& err);

/// Skipped rows with the reason, mismatches, and "N passed, M failed, K skipped" as the last line.
/// kFailure where a row differs from its reference, else kSuccess; throws UsageError where no row
/// ran.
int report_verdicts(const Verifier& verifier, std::ostream& out);

}  // namespace thinbench
