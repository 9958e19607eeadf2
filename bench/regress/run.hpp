// What thinbench_paired measured, read back from its samples.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "harness/operation.hpp"

namespace thinbench {

/// Medians over processes, in nanoseconds a call.
struct PairTimes {
  double reference_ns = 0;
  double row_ns = 0;
};

struct MeasuredRow {
  std::string name;  // case/technique/isa/threads/scope/input
  bool threaded = false;
  std::string input_hash;  // empty and 0 where the samples are older than these fields
  std::int64_t pixels = 0;
  std::vector<double> logs;  // ln(reference's time / row's time), a process each
  PairTimes times;
  CaseLabels labels = {};  // empty where the samples are older
};

/// The controls of a case on an input. Which row they are made of may differ between
/// processes that were planned one by one.
struct MeasuredControls {
  std::vector<std::string> base;
  std::vector<double> same;  // ln(reference's time / control's time), a process each
  std::vector<double> slowed;
};

struct MeasuredRun {
  std::size_t processes = 0;
  std::map<std::string, MeasuredRow> rows;
  std::map<std::string, MeasuredControls> controls;  // by group_of(name)
};

/// Case and input of a row: "case/input". Rows of a group are measured side by side.
[[nodiscard]] std::string group_of(const std::string& row);

/// Processes are counted on from file to file. Throws std::runtime_error for what
/// `--samples-out` did not write.
[[nodiscard]] MeasuredRun read_run(const std::vector<std::string>& files);

}  // namespace thinbench
