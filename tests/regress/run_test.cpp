#include "regress/run.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "paired/statistics.hpp"
#include "regress/sample_files.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

const std::string kSimd = "copy/simd_bytes/avx2/1/end_to_end/scene";

std::string error_of(const std::string& file) {
  try {
    static_cast<void>(read_run({file}));
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

TEST(GateSamples, ratios_times_and_controls_are_those_that_were_measured) {
  const TemporaryDirectory folder;
  const MeasuredRun run = read_run({folder.with("s.jsonl", samples_for_tests(1e-5))});
  EXPECT_EQ(run.processes, 9U);
  EXPECT_EQ(run.rows.size(), 3U);
  const MeasuredRow& row = run.rows.at(kSimd);
  EXPECT_NEAR(std::exp(median(row.logs)), 100, 0.01);
  EXPECT_NEAR(row.times.reference_ns, 1e6, 1);
  EXPECT_NEAR(row.times.row_ns, 1e4, 1);
  EXPECT_TRUE(run.rows.at("copy/simd_runs/avx2/2/end_to_end/scene").threaded);
  const MeasuredControls& controls = run.controls.at("copy/scene");
  EXPECT_EQ(controls.base, std::vector<std::string>(9, "copy/lut/baseline/1/end_to_end/scene"));
  EXPECT_NEAR(median(controls.slowed) - median(controls.same), -0.095, 0.001);
}

TEST(GateSamples, processes_of_several_files_are_one_run) {
  const TemporaryDirectory folder;
  const std::string first = folder.with("1.jsonl", samples_for_tests(1e-5));
  const MeasuredRun run = read_run({first, folder.with("2.jsonl", samples_for_tests(2e-5))});
  EXPECT_EQ(run.processes, 18U);
  EXPECT_EQ(run.rows.at(kSimd).logs.size(), 18U);
  EXPECT_NEAR(run.rows.at(kSimd).times.row_ns, 1.5e4, 1);
}

TEST(GateSamples, files_that_are_no_whole_samples_are_refused_by_name) {
  const TemporaryDirectory folder;
  const std::string whole = samples_for_tests(1e-5);
  const auto ends_with = [](const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
  };
  EXPECT_TRUE(ends_with(error_of(folder.file("absent.jsonl")), "absent.jsonl': cannot read it"));
  EXPECT_TRUE(ends_with(error_of(folder.with("a", whole.substr(0, whole.size() - 20))),
                        "a': a line is no JSON object"));
  EXPECT_TRUE(ends_with(error_of(folder.with("b", whole.substr(0, whole.find('\n') + 1))),
                        "b': it is truncated"));
  EXPECT_TRUE(ends_with(error_of(folder.with("c", "{\"kind\": \"run\", \"schema\": 2}\n")),
                        "c': its schema is unknown"));
  EXPECT_TRUE(ends_with(error_of(folder.with("d", "{}\n")), "d': it holds no samples"));
}

}  // namespace
}  // namespace thinbench
