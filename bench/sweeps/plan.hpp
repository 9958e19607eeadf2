// What is measured: sweeps as lists of points.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/operation.hpp"
#include "sweeps/input.hpp"

namespace thinbench {

struct SweepInfo {
  std::string_view name;
  std::string_view about;  // what x and y are
};

/// "density", "size", "threads", "depth", "isa".
[[nodiscard]] std::span<const SweepInfo> all_sweeps();

/// One place of a sweep: a row on an input, end to end.
struct Point {
  std::string_view sweep;
  double x = 0;
  std::optional<double> y;
  SweepInput input;
  const Operation* operation = nullptr;
  const Variant* variant = nullptr;
  int threads = 1;

  /// case/technique/isa/threads.
  [[nodiscard]] std::string row() const;
  /// Tells points apart, and names them in messages.
  [[nodiscard]] std::string name() const;
  /// Threads are compared by wall time, all else by processor time, which others disturb less.
  [[nodiscard]] std::string_view clock() const {
    return sweep == "threads" ? "wall" : "thread_cpu";
  }
};

struct SweepPlanOptions {
  std::vector<std::string> only;  // names of sweeps; all where empty
  std::string filter;             // rows whose name contains a match
  bool quick = false;             // smaller images and coarser steps
  int processors = 1;             // that threads may use
};

/// The points of all sweeps that are asked for, input by input. Rows that cannot run here are left
/// out. Points point to `operations`. Throws std::invalid_argument where the filter is malformed.
[[nodiscard]] std::vector<Point> plan_points(const SweepPlanOptions& options,
                                             const std::vector<Operation>& operations);

/// 1 to 8, steps of about a half more, and `processors` itself.
[[nodiscard]] std::vector<int> thread_steps(int processors);

}  // namespace thinbench
