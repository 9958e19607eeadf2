#include "measure/sample_reporter.hpp"

#include <algorithm>
#include <cstdio>
#include <iostream>

#include "measure/repetition.hpp"
#include "support/file_error.hpp"

namespace thinbench {
namespace {

using Run = benchmark::BenchmarkReporter::Run;

/// Nanoseconds of a call.
double per_call(const Run& run, double seconds) {
  return 1e9 * seconds /
         static_cast<double>(std::max<benchmark::IterationCount>(run.iterations, 1));
}

double counter(const Run& run, const char* name) {
  const auto found = run.counters.find(name);
  return found == run.counters.end() ? 0 : found->second.value;
}

/// As rows are called everywhere: without how often it is repeated.
Run with_own_name(Run run) {
  run.run_name.repetitions.clear();
  return run;
}

bool is_for_people(const Run& run) {
  return run.error_occurred || run.repetitions <= 1 || run.aggregate_name == "median";
}

Run without_probes(Run run) {
  for (const char* name : {kProbeBefore, kProbeAfter, kCycle}) run.counters.erase(name);
  return run;
}

}  // namespace

SampleReporter::SampleReporter(const std::string& samples, bool for_people)
    : display_(benchmark::CreateDefaultDisplayReporter()), for_people_(for_people) {
  if (samples.empty()) return;
  samples_.open(samples, std::ios::binary);
  samples_ << "row,repetition,calls,wall_ns,cpu_ns,probe_before_ns,probe_after_ns,cycle_ns\n";
  if (!samples_.flush()) cannot_write_by_errno(samples);
}

bool SampleReporter::ReportContext(const Context& context) {
  return samples_.is_open() || display_->ReportContext(context);
}

void SampleReporter::ReportRuns(const std::vector<Run>& runs) {
  std::vector<Run> shown;
  for (const Run& run : runs) {
    const Run named = with_own_name(run);
    if (run.run_type == Run::RT_Iteration) write(named);
    if (!for_people_) shown.push_back(named);
    if (for_people_ && is_for_people(run)) shown.push_back(without_probes(named));
  }
  if (!samples_.is_open()) display_->ReportRuns(shown);
}

void SampleReporter::Finalize() {
  if (!samples_.is_open()) display_->Finalize();
}

void SampleReporter::write(const Run& run) {
  if (run.error_occurred) {
    has_failed_ = true;
    std::cerr << run.run_name.str() << ": " << run.error_message << '\n';
  } else if (samples_.is_open()) {
    char numbers[160];
    std::snprintf(numbers, sizeof numbers, ",%lld,%lld,%.5g,%.5g,%.5g,%.5g,%.4g\n",
                  static_cast<long long>(run.repetition_index),
                  static_cast<long long>(run.iterations), per_call(run, run.real_accumulated_time),
                  per_call(run, run.cpu_accumulated_time), counter(run, kProbeBefore),
                  counter(run, kProbeAfter), counter(run, kCycle));
    samples_ << run.run_name.str() << numbers << std::flush;
  }
}

}  // namespace thinbench
