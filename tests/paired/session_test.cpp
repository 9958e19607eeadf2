#include "paired/session.hpp"

#include <cstdlib>

#include <gtest/gtest.h>

#include "picture/picture.hpp"
#include "support/temporary_directory.hpp"
#include "timing/broken_operation.hpp"

namespace thinbench {
namespace {

struct Session {
  int status;
  std::string out;
  std::string err;
};

Session run(const std::vector<std::string>& arguments, const Measurer& measurer,
            const std::vector<Operation>& operations = copy_operations()) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int status = run_paired(arguments, operations, measurer);
  std::string out = testing::internal::GetCapturedStdout();
  return {status, std::move(out), testing::internal::GetCapturedStderr()};
}

/// Answers what a machine would on which a slowed control is slower by `slowed`.
Measurer made_up(double slowed) {
  return [slowed](const std::string& line, std::uint64_t, const LineSink& answer) {
    const Order order = order_from(line);
    for (std::size_t group = 0; group < order.groups.size(); ++group) {
      GroupTimes times{group, {}, {0, 2048}};
      const std::vector<Entry>& entries = order.groups[group].entries;
      for (const Entry& entry : entries) {
        const ClockTimes clock{{&entry == &entries.back() ? slowed : 0}, 1000};
        times.entries.push_back({clock, clock});
      }
      answer(to_line(times));
    }
  };
}

const std::vector<std::string> kGood = {"--filter", "copy/good/"};

TEST(PairedSession, controls_that_pass_are_a_success_with_files) {
  const TemporaryDirectory folder;
  const Session session = run({"--filter", "copy/good/", "--csv-out", folder.file("s.csv"),
                               "--samples-out", folder.file("s.jsonl")},
                              made_up(0.095));
  EXPECT_EQ(session.status, 0) << session.err;
  EXPECT_NE(session.err.find("PASS: a row against itself 1, slowed by 10 % 0.909"),
            std::string::npos);
  EXPECT_NE(session.out.find("copy/good/baseline/1/end_to_end/scene"), std::string::npos);
  EXPECT_EQ(folder.names(), (std::set<std::string>{"s.csv", "s.jsonl"}));
}

TEST(PairedSession, planted_slow_down_that_is_missed_is_inconclusive_with_status_3) {
  const Session session = run(kGood, made_up(0));
  EXPECT_EQ(session.status, 3);
  EXPECT_NE(session.err.find("INCONCLUSIVE: a row against itself 1, slowed by 10 % 1;"),
            std::string::npos)
      << session.err;
}

TEST(PairedSession, unproved_row_is_not_measured_and_the_status_is_2) {
  const Session session = run({}, made_up(0.095));
  EXPECT_EQ(session.status, 2);
  EXPECT_NE(session.err.find("not timed: copy/bad"), std::string::npos);
  EXPECT_EQ(session.out.find("copy/bad"), std::string::npos);
}

TEST(PairedSession, wrong_use_is_one_line_and_2) {
  const std::string see = "see 'thinbench_paired --help'\n";
  EXPECT_EQ(run({"--bogus"}, {}).err, "thinbench_paired: there is no option '--bogus'; " + see);
  EXPECT_EQ(run({"--processes", "0"}, {}).err,
            "thinbench_paired: --processes: expected an integer in [1, 99], got '0'; " + see);
  const Session nothing = run({"--filter", "no_such_row"}, {});
  EXPECT_EQ(nothing.status, 2);
  EXPECT_EQ(nothing.err, "thinbench_paired: no row to time; the filter is 'no_such_row'\n");
  EXPECT_EQ(run({"--filter", "copy/reference"}, {}).err,
            "thinbench_paired: no pair to measure; the filter is 'copy/reference'\n");
}

TEST(PairedSession, processes_count_on_from_the_first_seed_and_samples_name_the_input) {
  const TemporaryDirectory folder;
  std::vector<std::uint64_t> seeds;
  const Measurer measurer = [&](const std::string& order, std::uint64_t seed,
                                const LineSink& answer) {
    seeds.push_back(seed);
    made_up(0.095)(order, seed, answer);
  };
  run({"--filter", "copy/good/", "--processes", "3", "--first-seed", "7", "--samples-out",
       folder.file("s.jsonl")},
      measurer);
  EXPECT_EQ(seeds, (std::vector<std::uint64_t>{7, 8, 9}));
  const std::string samples = bytes_of(folder.file("s.jsonl"));
  EXPECT_NE(samples.find("\"pixels\":210120"), std::string::npos);
  EXPECT_NE(samples.find("\"input_hash\":\""), std::string::npos);
  EXPECT_EQ(samples.find("\"input_hash\":\"\""), std::string::npos);
}

TEST(PairedSession, rows_slower_than_the_limit_are_left_out_and_counted) {
  const Session session = run({"--filter", "copy/good/", "--slowest", "0"}, {});
  EXPECT_EQ(session.status, 2);
  EXPECT_EQ(session.err,
            "rows left out: 1 (too slow for --slowest)\n"
            "thinbench_paired: no pair to measure; the filter is 'copy/good/'\n");
}

TEST(PairedSession, files_that_cannot_be_written_are_refused_before_the_work) {
  const Session session = run({"--csv-out", "no_such_folder/s.csv"}, {});
  EXPECT_EQ(session.status, 1);
  EXPECT_EQ(session.err,
            "thinbench_paired: cannot write 'no_such_folder/s.csv': there is no directory "
            "'no_such_folder'\n");
}

TEST(PairedSession, process_that_answers_nonsense_or_too_little_is_a_failure) {
  const Session nonsense = run(
      kGood, [](const std::string&, std::uint64_t, const LineSink& answer) { answer("Killed"); });
  EXPECT_EQ(nonsense.status, 1);
  EXPECT_NE(nonsense.err.find("no line of measurements: 'Killed'"), std::string::npos);
  EXPECT_EQ(run(kGood, [](const std::string&, std::uint64_t, const LineSink&) {}).status, 1);
}

TEST(PairedSession, result_other_than_the_proved_one_stops_a_process) {
  const Measurer measurer = [](const std::string& line, std::uint64_t seed,
                               const LineSink& answer) {
    Order order = order_from(line);
    order.groups.front().entries.back().hash = "another";
    measure(order, seed, copy_operations(), answer);
  };
  const Session session = run(kGood, measurer);
  EXPECT_EQ(session.status, 1);
  EXPECT_NE(session.err.find("gave another result"), std::string::npos) << session.err;
}

TEST(PairedSession, pictures_are_binarised_alike_in_all_processes) {
  const TemporaryDirectory folder;
  const std::string file = folder.file("dot.pgm");
  ByteImage dot(20, 10);
  dot.at(7, 5) = 90;
  write_grey(file, dot.view());
  const Measurer measurer = [](const std::string& line, std::uint64_t seed,
                               const LineSink& answer) {
    const Order order = order_from(line);
    EXPECT_EQ(order.binarise.foreground, Foreground::dark);
    EXPECT_EQ(order.binarise.threshold, 80);
    measure(order, seed, copy_operations(), answer);  // fails for another result than was proved
  };
  const Session session =
      run({"--filter", "copy/good/", "--image", file, "--foreground", "dark", "--threshold", "80",
           "--processes", "2", "--rounds", "1", "--seconds-per-pair", "0"},
          measurer);
  EXPECT_EQ(session.err.find("warning: " + file + ": 99.5 % of the image is foreground"), 0U)
      << session.err;
  EXPECT_EQ(session.err.find("warning", 1), std::string::npos) << "said once: " << session.err;
  EXPECT_NE(session.status, 1) << session.err;
}

// What is found depends on the machine; that processes start, answer and end does not.
TEST(PairedSession, program_measures_in_processes_of_its_own) {
  const TemporaryDirectory folder;
  const std::string command =
      std::string(THINBENCH_PAIRED_PROGRAM) +
      " --filter '^edges_sobel/autovec/baseline/' --processes 2 --rounds 1 --csv-out " +
      folder.file("s.csv") + " >" + folder.file("out") + " 2>" + folder.file("err");
  const int status = std::system(command.c_str());  // NOLINT(cert-env33-c)
  const int exit_status = status / 256;
  EXPECT_TRUE(exit_status == 0 || exit_status == kInconclusive) << bytes_of(folder.file("err"));
  EXPECT_NE(bytes_of(folder.file("s.csv"))
                .find("\nedges_sobel,autovec,baseline,1,end_to_end,scene,"
                      "reference,"),
            std::string::npos);
}

}  // namespace
}  // namespace thinbench
