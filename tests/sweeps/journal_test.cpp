#include "sweeps/journal.hpp"

#include <fstream>

#include <gtest/gtest.h>

#include "support/temporary_directory.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

using nlohmann::json;

class SweepJournal : public testing::Test {
 protected:
  SweepJournal() : points(plan_points({{"isa"}, "^holes/simd_runs/", true, 1}, all_operations())) {
    header = journal_header({{"commit", "abc"}, {"date", "today"}}, points);
  }

  /// A journal with a proof and a sample.
  void write() {
    Journal journal = Journal::begin(path, header);
    journal.add(points[0], Proof{"reference", "0123", 0.25});
    journal.add(points[0], Sample{0, 500, 2});
  }

  void append(const std::string& text) const { std::ofstream(path, std::ios::app) << text; }

  /// What resuming is refused with; empty where it is not.
  std::string refusal(const json& other) {
    try {
      static_cast<void>(Journal::resume(path, other, points));
      return {};
    } catch (const FileError& error) {
      return error.what();
    }
  }

  TemporaryDirectory folder;
  std::string path = folder.file("sweeps.jsonl");
  std::vector<Point> points;
  json header;
};

TEST_F(SweepJournal, knows_again_what_was_written) {
  write();
  const Journal journal = Journal::resume(path, header, points);
  ASSERT_NE(journal.proof_of(points[0]), nullptr);
  EXPECT_EQ(journal.proof_of(points[0])->against, "reference");
  EXPECT_EQ(journal.proof_of(points[0])->hash, "0123");
  EXPECT_EQ(journal.proof_of(points[0])->seconds, 0.25);
  EXPECT_TRUE(journal.has(points[0], 0));
  EXPECT_FALSE(journal.has(points[0], 1));
  ASSERT_GT(points.size(), 1U);
  EXPECT_EQ(journal.proof_of(points[1]), nullptr);
  EXPECT_FALSE(journal.has(points[1], 0));
}

TEST_F(SweepJournal, samples_say_what_they_are) {
  write();
  const std::string text = bytes_of(path);
  const json sample = json::parse(text.substr(text.rfind('\n', text.size() - 2) + 1));
  EXPECT_EQ(sample.at("sweep"), "isa");
  EXPECT_EQ(sample.at("operation"), "holes");
  EXPECT_EQ(sample.at("technique"), "simd_runs");
  EXPECT_EQ(sample.at("threads"), 1);
  EXPECT_EQ(sample.at("pixels"), 510 * 412);
  EXPECT_EQ(sample.at("proved_against"), "reference");
  EXPECT_EQ(sample.at("ns"), 500);
  EXPECT_EQ(sample.at("calls"), 2);
  EXPECT_EQ(sample.at("round"), 0);
}

TEST_F(SweepJournal, last_line_that_was_cut_off_is_dropped_and_replaced) {
  write();
  const std::string whole = bytes_of(path);
  append(R"({"kind": "sample", "swe)");
  {
    Journal journal = Journal::resume(path, header, points);
    EXPECT_EQ(bytes_of(path), whole);
    journal.add(points[0], Sample{1, 700, 2});
  }
  const Journal journal = Journal::resume(path, header, points);
  EXPECT_TRUE(journal.has(points[0], 1));
}

TEST_F(SweepJournal, another_run_is_refused_with_what_differs) {
  write();
  json other = header;
  other["machine"]["commit"] = "def";
  EXPECT_EQ(refusal(other), "'" + path +
                                "' is of another run: machine/commit is \"abc\" there and \"def\" "
                                "here; resume it as it was begun, or begin another file");
  other = header;
  other["definition"] = "0";
  EXPECT_NE(refusal(other).find("definition is"), std::string::npos);
  other["machine"]["commit"] = "def";
  EXPECT_NE(refusal(other).find("machine/commit is"), std::string::npos) << "what the user chose";
  other = header;
  other["machine"]["date"] = "tomorrow";
  EXPECT_EQ(refusal(other), "");
}

TEST_F(SweepJournal, damaged_lines_and_other_files_are_refused) {
  write();
  const std::string whole = bytes_of(path);
  append("nonsense\n");
  EXPECT_EQ(refusal(header), "'" + path + "' is damaged: line 4 is none of this run");
  const std::string sample = whole.substr(whole.rfind('\n', whole.size() - 2) + 1);
  static_cast<void>(folder.with("sweeps.jsonl", whole + sample));
  EXPECT_NE(refusal(header).find("line 4"), std::string::npos) << "a round twice";
  for (const char* text : {"", "{}\n", "no journal\n", "{\"kind\": 7}\n"}) {
    static_cast<void>(folder.with("sweeps.jsonl", text));
    EXPECT_EQ(refusal(header),
              "'" + path + "' is no journal of sweeps: its first line is no header");
  }
}

TEST_F(SweepJournal, file_that_is_there_is_not_begun_again) {
  write();
  const std::string before = bytes_of(path);
  EXPECT_THROW(static_cast<void>(Journal::begin(path, header)), FileError);
  EXPECT_EQ(bytes_of(path), before);
  EXPECT_THROW(static_cast<void>(Journal::begin(folder.file("no/folder"), header)), FileError);
  std::filesystem::remove(path);
  EXPECT_NE(refusal(header).find("cannot be opened: No such file"), std::string::npos);
}

TEST_F(SweepJournal, two_processes_cannot_write_at_once) {
  const Journal journal = Journal::begin(path, header);
  EXPECT_EQ(refusal(header), "'" + path + "' is being written by another process");
}

}  // namespace
}  // namespace thinbench
