// Runs of a machine of known noise: what an operation with some rows would have given.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "regress/run.hpp"
#include "support/splitmix64.hpp"

namespace thinbench {

inline constexpr std::size_t kProcesses = 9;
inline constexpr int kRowsForTests = 20;

/// Numbers of the normal distribution, the same for the same seed.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : seed_(seed) {}
  double operator()(double sigma) {
    const double length = std::sqrt(-2 * std::log(uniform()));
    return sigma * length * std::cos(2 * std::numbers::pi * uniform());
  }

 private:
  double uniform() {
    return (static_cast<double>(splitmix64(seed_, index_++) >> 11) + 1) * std::exp2(-53);
  }
  std::uint64_t seed_;
  std::uint64_t index_ = 0;
};

/// Standard deviations of logarithms, about as a busy virtual machine shows them.
struct Machine {
  double row_noise = 0.009;        // from process to process
  double reference_noise = 0.012;  // common to all rows of a process
  double layout_noise = 0.03;      // of one process in eight
};

inline std::string row_for_tests(int index) {
  return "copy/simd_bytes" + std::to_string(index) + "/avx2/1/kernel/scene";
}

/// Rows are 10 times as fast as their reference, the last of them is what controls are made of;
/// row 0 is slower than that by `slowed`.
inline MeasuredRun run_for_tests(std::uint64_t seed, double slowed = 0,
                                 const Machine& machine = {}) {
  Noise noise(seed);
  MeasuredRun run;
  run.processes = kProcesses;
  for (int i = 0; i < kRowsForTests; ++i) {
    const double row_ns = 1e4 * (i == 0 ? 1 + slowed : 1);
    run.rows[row_for_tests(i)] = {row_for_tests(i), false, "hash", 210120, {}, {1e5, row_ns}};
  }
  MeasuredControls& controls = run.controls["copy/scene"];
  for (std::size_t process = 0; process < kProcesses; ++process) {
    const double reference = noise(machine.reference_noise);
    for (int i = 0; i < kRowsForTests; ++i) {
      MeasuredRow& row = run.rows[row_for_tests(i)];
      const bool odd_layout =
          splitmix64(seed, process * 100 + static_cast<std::size_t>(i)) % 8 == 0;
      const double log = noise(odd_layout ? machine.layout_noise : machine.row_noise);
      row.logs.push_back(reference + log + std::log(row.times.reference_ns / row.times.row_ns));
    }
    const std::string base = row_for_tests(kRowsForTests - 1);
    const double log = run.rows[base].logs.back();
    controls.base.push_back(base);
    controls.same.push_back(log + noise(0.002));
    controls.slowed.push_back(log - std::log(1.1) + noise(0.002));
  }
  return run;
}

}  // namespace thinbench
