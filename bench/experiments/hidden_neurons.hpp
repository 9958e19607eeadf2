// "Successive tests have shown that a number of eight hidden neurones is optimal" (section 3.2): is
// it?
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "experiments/report.hpp"

namespace thinbench {

struct HiddenNeuronsChoice {
  int fewest = 2;
  int most = 12;
  int seeds = 20;         // 1, 2, ... this many; one start each
  int max_epochs = 2000;  // of each start

  const char* options = "";  // of the command that chose so

  /// What `--quick` runs: enough to see that it works.
  static HiddenNeuronsChoice quick() { return {2, 12, 3, 1000, " --quick"}; }
};

struct HiddenNeuronsRow {
  int hidden;
  int seeds;
  int best;       // descriptors of 256 with the sigmoid
  double median;  // over seeds
  int perfect;    // seeds that reached 256
  double epochs;  // median over those; 0 if there are none
};

/// Called before each number of hidden neurons with the share that is done, 0 to 1.
using ProgressReport = std::function<void(double)>;

[[nodiscard]] std::vector<HiddenNeuronsRow> run_hidden_neurons(const HiddenNeuronsChoice& choice,
                                                               const ProgressReport& progress);

/// The smallest number that reached 256 with any seed; 0 if none did.
[[nodiscard]] int fewest_hidden_neurons(const std::vector<HiddenNeuronsRow>& rows);

[[nodiscard]] ExperimentReport hidden_neurons_report(const std::vector<HiddenNeuronsRow>& rows,
                                                     const HiddenNeuronsChoice& choice);

}  // namespace thinbench
