// Shows the results of Google Benchmark, or writes a line of CSV for each repetition.
#pragma once

#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace thinbench {

class SampleReporter : public benchmark::BenchmarkReporter {
 public:
  /// Writes to the file of this name and shows nothing, unless the name is empty. `for_people`
  /// leaves one line of each benchmark, the median. Throws FileError.
  SampleReporter(const std::string& samples, bool for_people);

  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

  [[nodiscard]] bool has_failed() const { return has_failed_; }

 private:
  void write(const Run& run);

  std::unique_ptr<benchmark::BenchmarkReporter> display_;
  std::ofstream samples_;
  bool for_people_;
  bool has_failed_ = false;
};

}  // namespace thinbench
