#include "study/study.hpp"

#include "support/whole_file.hpp"

namespace thinbench {

void check_targets(std::initializer_list<std::string> paths) {
  for (const std::string& path : paths) {
    if (!path.empty()) check_target(path);
  }
}

void write_if_named(const std::string& path, const std::string& text, std::ostream& err) {
  if (path.empty()) return;
  write_whole_file(path, text);
  err << "wrote " << path << '\n';
}

const ProgramInfo& study_program() {
  static const ProgramInfo program = {
      "thinbench-study",
      "Verify that every variant of thinbench is right, and measure it",
      R"(Examples:
  thinbench-study list --variants
  thinbench-study run thin_guo_hall parts.png skeleton.png --technique lut
  thinbench-study verify --quick
  thinbench-study scene parts.png
  thinbench-study train cluster
  thinbench-study instructions --out counts.json

THINBENCH_MAX_ISA=avx2 (or baseline, sse4.2, avx512, avx512icl) caps the instruction set.)",
      {&add_study_list_command, &add_study_run_command, &add_verify_command, &add_scene_command,
       &add_train_command, &add_experiment_command, &add_instructions_command,
       &add_circuits_command}};
  return program;
}

}  // namespace thinbench
