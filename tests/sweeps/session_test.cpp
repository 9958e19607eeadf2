#include "sweeps/session.hpp"

#include <chrono>
#include <csignal>
#include <map>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include "support/temporary_directory.hpp"
#include "timing/broken_operation.hpp"

namespace thinbench {
namespace {

struct Session {
  int status;
  std::string err;
};

Session run(const std::vector<std::string>& arguments,
            const std::vector<Operation>& operations = all_operations()) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int status = run_sweeps(arguments, operations);
  static_cast<void>(testing::internal::GetCapturedStdout());
  return {status, testing::internal::GetCapturedStderr()};
}

/// How often each round of each point is in a journal; every line has to be whole.
std::map<std::string, int> samples_of(const std::string& path) {
  std::map<std::string, int> counts;
  std::istringstream lines(bytes_of(path));
  for (std::string line; std::getline(lines, line);) {
    nlohmann::json sample = nlohmann::json::parse(line);
    if (sample.at("kind") != "sample") continue;
    for (const char* value : {"ns", "calls"}) sample.erase(value);
    ++counts[sample.dump()];
  }
  return counts;
}

const std::vector<std::string> kTiny = {"--only", "isa", "--quick", "--filter",
                                        "^edges_sobel/(simd_16bit|autovec)/baseline/1"};

std::vector<std::string> tiny(std::vector<std::string> more) {
  more.insert(more.begin(), kTiny.begin(), kTiny.end());
  return more;
}

TEST(SweepsSession, every_point_gets_a_sample_a_round) {
  const TemporaryDirectory folder;
  const std::string path = folder.file("sweeps.jsonl");
  ASSERT_EQ(run(tiny({"--rounds", "2", "--out", path})).status, 0);
  const auto samples = samples_of(path);
  EXPECT_EQ(samples.size(), 4U);
  for (const auto& [sample, count] : samples) EXPECT_EQ(count, 1) << sample;
}

TEST(SweepsSession, stops_after_a_round_and_goes_on_where_it_stopped) {
  const TemporaryDirectory folder;
  const std::string path = folder.file("sweeps.jsonl");
  ASSERT_EQ(run(tiny({"--rounds", "2", "--stop-after", "1", "--out", path})).status, 0);
  EXPECT_EQ(samples_of(path).size(), 2U);
  ASSERT_EQ(run(tiny({"--rounds", "2", "--resume", path})).status, 0);
  EXPECT_EQ(samples_of(path).size(), 4U);
  const Session other = run(tiny({"--rounds", "3", "--resume", path}));
  EXPECT_EQ(other.status, 1);
  EXPECT_NE(other.err.find("is of another run: machine/options/rounds is 2 there and 3 here"),
            std::string::npos)
      << other.err;
}

TEST(SweepsSession, wrong_use_is_one_line_and_2) {
  const std::string see = "; see 'thinbench_sweeps --help'\n";
  EXPECT_EQ(run({"--only", "densty"}).err,
            "thinbench_sweeps: --only: there is no sweep 'densty'; choose from density, size, "
            "threads, depth, enlarged, isa" +
                see);
  EXPECT_EQ(run({}).err, "thinbench_sweeps: --out FILE or --resume FILE is needed" + see);
  EXPECT_EQ(run({"--rounds", "0"}).err,
            "thinbench_sweeps: --rounds: expected an integer in [1, 999], got '0'" + see);
  const Session nothing = run({"--filter", "no_such_row", "--out", "x"});
  EXPECT_EQ(nothing.status, 2);
  EXPECT_EQ(nothing.err, "thinbench_sweeps: no row to measure; the filter is 'no_such_row'\n");
  EXPECT_EQ(run({"--out", "no_such_folder/x"}).status, 1);
}

TEST(SweepsSession, file_that_is_there_is_refused_with_what_to_do) {
  const TemporaryDirectory folder;
  const std::string path = folder.with("sweeps.jsonl", "mine");
  const Session session = run(tiny({"--out", path}));
  EXPECT_EQ(session.status, 1);
  EXPECT_EQ(session.err, "thinbench_sweeps: '" + path +
                             "' is there already: go on with it by --resume, or choose another "
                             "name\n");
  EXPECT_EQ(bytes_of(path), "mine");
}

TEST(SweepsSession, row_that_is_not_equal_is_not_timed_and_the_status_is_2) {
  const TemporaryDirectory folder;
  std::vector<Operation> operations = copy_operations();
  operations.front().name = "holes";  // a name that sweeps ask for
  const std::string path = folder.file("sweeps.jsonl");
  const Session session = run({"--only", "isa", "--rounds", "1", "--out", path}, operations);
  EXPECT_EQ(session.status, 2);
  EXPECT_NE(session.err.find("not equal, not timed: isa x=0 holes/bad"), std::string::npos)
      << session.err;
  EXPECT_EQ(samples_of(path).size(), 1U);
}

/// Starts the program; standard error goes to a file.
pid_t started(std::vector<std::string> arguments, const std::string& err) {
  arguments.insert(arguments.begin(), THINBENCH_SWEEPS_PROGRAM);
  std::vector<char*> words;
  words.reserve(arguments.size() + 1);
  for (std::string& word : arguments) words.push_back(word.data());
  words.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    if (std::freopen(err.c_str(), "w", stderr) != nullptr) execv(words[0], words.data());
    _exit(99);
  }
  return child;
}

int exit_status_of(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void interrupted_run_can_be_completed(int signal) {
  const TemporaryDirectory folder;
  const std::string path = folder.file("sweeps.jsonl");
  const auto with = [&](const char* option) { return tiny({"--rounds", "200", option, path}); };
  const pid_t child = started(with("--out"), folder.file("err"));
  while (bytes_of(path).find("\"sample\"") == std::string::npos) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  kill(child, signal);
  EXPECT_EQ(exit_status_of(child), kInterrupted);
  const std::string err = bytes_of(folder.file("err"));
  EXPECT_NE(err.find("interrupted; go on by the same command with --resume '" + path + "' instead"),
            std::string::npos)
      << err;
  const std::size_t before = samples_of(path).size();
  EXPECT_LT(before, 400U);
  EXPECT_EQ(exit_status_of(started(with("--resume"), folder.file("err"))), 0);
  const auto samples = samples_of(path);
  EXPECT_EQ(samples.size(), 400U);
  for (const auto& [sample, count] : samples) EXPECT_EQ(count, 1) << sample;
}

TEST(SweepsProgram, ctrl_c_leaves_a_journal_that_can_be_completed) {
  interrupted_run_can_be_completed(SIGINT);
}

TEST(SweepsProgram, termination_leaves_a_journal_that_can_be_completed) {
  interrupted_run_can_be_completed(SIGTERM);
}

}  // namespace
}  // namespace thinbench
