#include "timing/session.hpp"

#include <benchmark/benchmark.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "peers/peers.hpp"
#include "picture/picture.hpp"
#include "support/temporary_directory.hpp"
#include "timing/broken_operation.hpp"

namespace thinbench {
namespace {

struct Session {
  int status;
  std::string err;
};

Session run(std::vector<std::string> args, const std::vector<Operation>& operations) {
  args.insert(args.begin(), "thinbench_timings");
  std::vector<char*> pointers;
  for (std::string& arg : args) pointers.push_back(arg.data());
  benchmark::ClearRegisteredBenchmarks();
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int status = run_timings(pointers, operations);
  static_cast<void>(testing::internal::GetCapturedStdout());
  return {status, testing::internal::GetCapturedStderr()};
}

Session run_copies(const std::vector<std::string>& more, const std::string& filter) {
  std::vector<std::string> args = {"--quiet", "--largest-square", "0",      "--repetitions",
                                   "1",       "--seconds",        "0.0001", "--filter",
                                   filter};
  args.insert(args.end(), more.begin(), more.end());
  return run(args, copy_operations());
}

TEST(TimingSession, all_rows_proved_is_a_success) {
  const Session session = run_copies({}, "copy/good/");
  EXPECT_EQ(session.status, 0) << session.err;
  EXPECT_EQ(session.err.find("1 variants equal to the reference; timing 2 rows"), 0U);
}

TEST(TimingSession, unproved_row_is_untimed_and_the_exit_status_is_2) {
  const TemporaryDirectory folder;
  const std::string out = folder.file("timings.json");
  const std::string rows = folder.file("rows.json");
  const Session session =
      run_copies({"--rows-out", rows, "--benchmark_out=" + out, "--benchmark_out_format=json"}, "");
  EXPECT_EQ(session.status, 2);
  EXPECT_NE(session.err.find("not equal to the reference, not timed: copy/bad/baseline/1/scene: "),
            std::string::npos)
      << session.err;
  EXPECT_NE(session.err.find("rows skipped: 1 (this machine lacks it)"), std::string::npos);
  EXPECT_EQ(bytes_of(out).find("copy/bad"), std::string::npos);
  EXPECT_NE(bytes_of(out).find("copy/good"), std::string::npos);
  const auto json = nlohmann::json::parse(bytes_of(rows));
  EXPECT_EQ(json.at("failed"), 1);
  EXPECT_EQ(json.at("/skipped/0/row"_json_pointer), "copy/absent/baseline/1/scene");
}

/// In a process of its own: Google Benchmark's help would end this one, as if all were well.
TEST(TimingSessionDeathTest, help_is_our_own) {
  for (const char* word : {"--help", "-h"}) {
    const auto ask = [word] {
      std::string program = "thinbench_timings";
      std::string option = word;
      std::exit(40 + run_timings({program.data(), option.data()}, copy_operations()));
    };
    EXPECT_EXIT(ask(), testing::ExitedWithCode(40), "");
  }
}

TEST(TimingSession, filter_that_matches_nothing_ends_with_2) {
  const Session session = run_copies({}, "no_such_row");
  EXPECT_EQ(session.status, 2);
  EXPECT_EQ(session.err, "thinbench_timings: no row to time; the filter is 'no_such_row'\n");
}

TEST(TimingSession, wrong_options_are_one_line_and_2) {
  const std::string see = "see 'thinbench_timings --help'\n";
  EXPECT_EQ(run({"--bogus"}, {}).err, "thinbench_timings: there is no option '--bogus'; " + see);
  EXPECT_EQ(run({"--bogus"}, {}).status, 2);
  EXPECT_EQ(run({"--repetitions", "0"}, {}).err,
            "thinbench_timings: --repetitions: expected an integer in [1, 1000], got '0'; " + see);
  EXPECT_EQ(run({"--rows-out", ""}, {}).err,
            "thinbench_timings: --rows-out: expected a value, got ''; " + see);
  EXPECT_EQ(run_copies({}, "(").err.find("thinbench_timings: --filter: '(' is no regular"), 0U);
}

TEST(TimingSession, pictures_are_binarised_as_asked_for_with_remarks_on_standard_error) {
  const TemporaryDirectory folder;
  const std::string file = folder.file("dot.pgm");
  ByteImage dot(20, 10);
  dot.at(7, 5) = 90;
  write_grey(file, dot.view());
  const std::string rows = folder.file("rows.json");
  const auto err = [&](const std::vector<std::string>& more) {
    std::vector<std::string> args = {"--benchmark_out=", "--image", file, "--rows-out", rows};
    args.insert(args.end(), more.begin(), more.end());
    return run_copies(args, "copy/good/").err;
  };
  const auto foreground = [&] {
    return nlohmann::json::parse(bytes_of(rows)).at("/inputs/0/object_pixels"_json_pointer);
  };
  EXPECT_EQ(err({}).find("note: " + file + ": foreground is bright"), 0U);
  EXPECT_EQ(foreground(), 1);
  EXPECT_EQ(err({"--foreground", "dark", "--threshold", "80"}).find("warning: " + file), 0U);
  EXPECT_EQ(foreground(), 199);
  EXPECT_EQ(run({"--threshold", "80"}, {}).err,
            "thinbench_timings: --threshold requires --image; see 'thinbench_timings --help'\n");
}

TEST(TimingSession, files_that_cannot_be_written_are_refused_before_the_work) {
  const Session session = run_copies({"--rows-out", "no_such_folder/rows.json"}, "");
  EXPECT_EQ(session.status, 1);
  EXPECT_EQ(session.err,
            "thinbench_timings: cannot write 'no_such_folder/rows.json': there is no directory "
            "'no_such_folder'\n");
}

TEST(TimingSession, no_peers_leaves_them_out_of_rows_and_list) {
  const TemporaryDirectory folder;
  const std::string rows = folder.file("rows.json");
  const std::vector<std::string> args = {
      "--benchmark_out=", "--quiet",
      "--largest-square", "0",
      "--repetitions",    "1",
      "--seconds",        "0.0001",
      "--filter",         "^edges_sobel/(copy/native|autovec/baseline)/1/",
      "--rows-out",       rows};
  EXPECT_EQ(run(args, operations_with_peers()).err.find("2 variants equal"), 0U);
  EXPECT_EQ(nlohmann::json::parse(bytes_of(rows)).at("peers").size(), peers().size());
  std::vector<std::string> without = args;
  without.emplace_back("--no-peers");
  EXPECT_EQ(run(without, operations_with_peers()).err.find("1 variants equal"), 0U);
  EXPECT_EQ(nlohmann::json::parse(bytes_of(rows)).at("peers").size(), 0U);
}

}  // namespace
}  // namespace thinbench
