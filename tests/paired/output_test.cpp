#include "paired/output.hpp"

#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "paired/processes_for_tests.hpp"

namespace thinbench {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class Output : public testing::Test {
 protected:
  Output() : rows(1e-3) {
    rows.with("lut", 5e-4);
    rows.with("simd_bytes", 1e-5, Isa::avx2);
    groups = {plan_group(rows.rows(), {9, 1})};
    processes = processes_of(groups[0], {}, rows.rows());
    results = results_of(groups, processes);
  }

  RowsForTests rows;
  std::vector<Group> groups;
  std::vector<std::vector<GroupTimes>> processes;
  std::vector<PairResult> results;
};

TEST_F(Output, csv_has_the_columns_that_readers_know) {
  const std::vector<std::string> lines = lines_of(to_csv(results));
  EXPECT_EQ(lines[0],
            "operation,technique,isa,threads,scope,input,against,ratio,low,high,processes,rounds,"
            "reference_ns,variant_ns,clock,layout,output_hash,flags,verified,against_row,border,"
            "max_iterations");
  EXPECT_EQ(lines[1],
            "copy,lut,baseline,1,end_to_end,scene,reference,2,1.994,2.006,9,18,1000000,500000,"
            "thread_cpu,0+2048,0123456789abcdef,via,1,reference/baseline/1/end_to_end,,");
  EXPECT_EQ(lines.size(), 1 + results.size());
}

TEST_F(Output, csv_and_samples_tell_cases_of_one_operation_apart) {
  groups[0].entries[1].name = "thin_a:keep:1/lut/baseline/1/end_to_end/scene";
  groups[0].entries[1].labels = {"thin_a", "keep", 1};
  EXPECT_EQ(lines_of(to_csv(results))[1].find("thin_a,lut,baseline,1,end_to_end,scene,"), 0U);
  EXPECT_TRUE(lines_of(to_csv(results))[1].ends_with(",reference/baseline/1/end_to_end,keep,1"));
  const auto sample = nlohmann::json::parse(lines_of(to_json_lines(groups, processes, results))[2]);
  EXPECT_EQ(sample.at("operation"), "thin_a");
  EXPECT_EQ(sample.at("border"), "keep");
  EXPECT_EQ(sample.at("max_iterations"), 1);
}

TEST_F(Output, csv_quotes_names_of_pictures_that_need_it) {
  groups[0].entries[1].name = "copy/lut/baseline/1/end_to_end/a,\"b";
  EXPECT_NE(to_csv(results).find(",\"a,\"\"b\",reference,"), std::string::npos);
}

TEST_F(Output, samples_are_json_lines_from_which_the_ratios_follow) {
  const std::vector<std::string> lines = lines_of(to_json_lines(groups, processes, results));
  EXPECT_EQ(lines.size(), 1 + 9 * groups[0].entries.size());
  const auto run = nlohmann::json::parse(lines[0]);
  EXPECT_EQ(run.at("verdict"), "PASS");
  EXPECT_EQ(run.at("interval_ranks"), (std::vector<int>{2, 8}));
  for (const std::string& line : lines) EXPECT_TRUE(nlohmann::json::parse(line).contains("kind"));
  const auto sample = nlohmann::json::parse(lines[2]);
  EXPECT_EQ(sample.at("row"), groups[0].entries[1].name);
  EXPECT_EQ(sample.at("thread_cpu").at("logs").size(), 3U);
}

TEST_F(Output, verdict_says_interval_and_coverage) {
  EXPECT_EQ(verdict_line(results),
            "PASS: a row against itself 1, slowed by 10 % 0.90937; 0 of 1 cases flagged by "
            "their own controls; intervals from 2 to 8 of 9 ordered process values, coverage "
            "96.1 %");
}

}  // namespace
}  // namespace thinbench
