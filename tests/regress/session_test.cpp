#include "regress/session.hpp"

#include <gtest/gtest.h>

#include "regress/sample_files.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

using nlohmann::json;

class GateSession : public testing::Test {
 protected:
  struct Result {
    int status;
    std::string out;
    std::string err;
  };

  Result run(const std::vector<std::string>& arguments) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int status = run_regress(arguments, machine);
    std::string out = testing::internal::GetCapturedStdout();
    return {status, std::move(out), testing::internal::GetCapturedStderr()};
  }

  std::string samples(const std::string& name, double seconds, const MadeUp& made_up = {}) {
    return folder.with(name, samples_for_tests(seconds, made_up));
  }

  Result update(double seconds, const MadeUp& made_up = {}) {
    return run({"update", "--run", samples("base.jsonl", seconds, made_up), "--baselines",
                folder.path().string(), "--commit", "0123456789", "--reason", "for tests"});
  }

  /// With a second run as the first.
  Result compare(double seconds) {
    const std::string file = samples("run.jsonl", seconds);
    return run({"compare", "--run", file, "--again", file, "--baselines", folder.path().string()});
  }

  TemporaryDirectory folder;
  json machine = {{"fingerprint", "machine-1"},
                  {"commit", "unknown"},
                  {"date", "2026-01-01T00:00:00Z"},
                  {"caches", {{{"level", 2}, {"size_kib", 2048}}}}};
};

TEST_F(GateSession, no_baseline_for_this_machine_is_said_and_never_green) {
  const Result none = compare(1e-5);
  EXPECT_EQ(none.status, 4);
  EXPECT_NE(none.out.find("INFO: there is no baseline for this processor, compiler and flags "
                          "(machine-1)"),
            std::string::npos);
  EXPECT_NE(none.out.find("SKIPPED: nothing was compared\n"), std::string::npos);
  ASSERT_EQ(update(1e-5).status, 0);
  machine["fingerprint"] = "machine-2";
  EXPECT_EQ(compare(1e-5).status, 4);
}

TEST_F(GateSession, baseline_of_another_compiler_under_this_name_is_not_compared) {
  ASSERT_EQ(update(1e-5).status, 0);
  std::filesystem::rename(folder.file("machine-1.json"), folder.file("machine-2.json"));
  machine["fingerprint"] = "machine-2";
  EXPECT_EQ(compare(1e-5).status, 4);
}

TEST_F(GateSession, run_as_fast_as_the_baseline_passes) {
  ASSERT_EQ(update(1e-5).status, 0);
  const Result result = compare(1e-5);
  EXPECT_EQ(result.status, 0) << result.out << result.err;
  EXPECT_NE(result.out.find("rows against before: PASS 2, SKIPPED 1\n"), std::string::npos);
  EXPECT_NE(result.out.find("controls passed: a row against itself 1.000"), std::string::npos);
  EXPECT_NE(result.out.find("slowed by 10 % on purpose 0.909"), std::string::npos);
}

TEST_F(GateSession, slower_row_fails_with_both_times_and_what_moved) {
  ASSERT_EQ(update(1e-5).status, 0);
  const Result result = compare(1.2e-5);
  EXPECT_EQ(result.status, 1) << result.out << result.err;
  EXPECT_NE(result.out.find("FAIL          copy/simd_bytes/avx2/1/end_to_end/scene\n"),
            std::string::npos);
  EXPECT_NE(result.out.find("row 10.0 -> 12.0 us, reference 1000.0 -> 1000.0 us: row 20 % slower"),
            std::string::npos)
      << result.out;
}

TEST_F(GateSession, ten_percent_fail_between_two_builds_and_operations_to_measure_again_are_named) {
  const std::string rerun = folder.file("rerun");
  const std::string old = samples("old.jsonl", 1e-5);
  const std::string now = samples("now.jsonl", 1.1e-5);
  EXPECT_EQ(run({"compare", "--old", old, "--run", now, "--rerun-out", rerun}).status, 1);
  EXPECT_EQ(bytes_of(rerun), "copy\n");
  const Result confirmed =
      run({"compare", "--old", old, "--run", now, "--old-again", old, "--again", now});
  EXPECT_EQ(confirmed.status, 1);
  const Result vanished =
      run({"compare", "--old", old, "--run", now, "--old-again", old, "--again", old});
  EXPECT_EQ(vanished.status, 3);
  EXPECT_NE(vanished.out.find("first FAIL, then PASS"), std::string::npos) << vanished.out;
  EXPECT_EQ(run({"compare", "--old", old, "--run", old, "--rerun-out", rerun}).status, 0);
  EXPECT_EQ(bytes_of(rerun), "\n");
}

TEST_F(GateSession, failed_control_is_inconclusive_and_makes_no_baseline) {
  EXPECT_EQ(update(1e-5, {0.05}).status, 3);
  EXPECT_FALSE(std::filesystem::exists(folder.file("machine-1.json")));
  const std::string file = samples("run.jsonl", 2e-5, {0.05});
  EXPECT_EQ(run({"compare", "--run", file, "--old", samples("old.jsonl", 1e-5)}).status, 3);
}

TEST_F(GateSession, history_keeps_reasons_and_by_how_much_rows_changed) {
  ASSERT_EQ(update(1e-5).status, 0);
  ASSERT_EQ(update(5e-6).status, 0);
  const json baseline = json::parse(bytes_of(folder.file("machine-1.json")));
  const json& history = baseline.at("history");
  ASSERT_EQ(history.size(), 2U);
  EXPECT_TRUE(history[0].at("change").is_null());
  EXPECT_NEAR(history[1].at("change").get<double>(), std::cbrt(2), 1e-3);
  EXPECT_EQ(history[1].at("reason"), "for tests");
  EXPECT_EQ(history[1].at("commit"), "0123456789");
  EXPECT_EQ(baseline.at("machine").at("commit"), "0123456789");
  const json& row = baseline.at("rows").at("copy/simd_bytes/avx2/1/end_to_end/scene");
  EXPECT_NEAR(row.at("ratio").get<double>(), 200, 0.1);
  EXPECT_NEAR(row.at("reference_ns").get<double>(), 1e6, 1);
}

TEST_F(GateSession, baselines_that_cannot_be_read_are_refused_in_one_line) {
  const auto refused = [&](const std::string& text) {
    static_cast<void>(folder.with("machine-1.json", text));
    const Result result = compare(1e-5);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1);
    return result.err.substr(result.err.rfind(".json': ") + 8);
  };
  EXPECT_EQ(refused("{\"kind\": \"base"), "it is no JSON object, or truncated\n");
  EXPECT_EQ(refused("{}"), "it is no baseline\n");
  EXPECT_EQ(refused(R"({"kind": "baseline", "schema": 2})"), "its schema 2 is unknown\n");
}

TEST_F(GateSession, counts_are_named_after_the_machine_and_are_no_baseline_of_another) {
  const std::string counts = folder.file("machine-1-instructions.json");
  EXPECT_EQ(run({"counts-file", "--baselines", folder.path().string()}).out, counts + "\n");
  static_cast<void>(folder.with("machine-2-instructions.json", "{}"));
  const Result none = compare(1e-5);
  EXPECT_EQ(none.status, 4);
  EXPECT_NE(none.out.find("but 0 for others"), std::string::npos) << none.out;
}

TEST_F(GateSession, wrong_usage_has_a_status_of_its_own) {
  EXPECT_EQ(run({}).status, 2);
  EXPECT_EQ(run({"counts-file"}).status, 2);
  EXPECT_EQ(run({"update", "--run", "s", "--baselines", "b", "--commit", "c"}).status, 2);
  EXPECT_EQ(run({"compare", "--run", "s", "--old", "o", "--baselines", "b"}).status, 2);
}

}  // namespace
}  // namespace thinbench
