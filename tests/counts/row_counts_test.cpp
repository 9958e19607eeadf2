#include "counts/row_counts.hpp"

#include <csignal>

#include <gtest/gtest.h>

#include "core/isa.hpp"
#include "counts/counted_input.hpp"

namespace thinbench {
namespace {

const std::vector<TimedInput>& small_inputs() {
  static const std::vector<TimedInput> inputs = [] {
    std::vector<TimedInput> few;
    few.push_back(middle_rows(small_copy(timed_inputs({{}, 0}).front()), 6));
    return few;
  }();
  return inputs;
}

std::vector<TimedRow> rows_matching(const std::string& filter) {
  Selection selection = select_rows(filter, all_operations(), small_inputs());
  std::erase_if(selection.rows, [](const TimedRow& row) { return row.variant == nullptr; });
  return std::move(selection.rows);
}

/// Look-up table, packed words and the best of SIMD here, end to end.
std::vector<TimedRow> three_rows() {
  const std::string best(isa_name(best_isa()));
  std::vector<TimedRow> rows = rows_matching(
      "^thin_guo_hall/(lut/baseline|bitpacked/baseline|simd_bitpacked/" + best + ")/1/end_to_end");
  return rows;
}

std::vector<std::uint64_t> instructions_in(const RowCounts& counts) {
  std::vector<std::uint64_t> numbers;
  for (const RowCount& count : counts.rows) numbers.push_back(count.instructions);
  return numbers;
}

TEST(RowCounts, counting_twice_gives_equal_numbers) {
  const std::vector<TimedRow> rows = three_rows();
  ASSERT_EQ(rows.size(), 3U);
  const std::uint64_t enough = 5000000;
  const std::vector<std::uint64_t> first = instructions_in(counts_of(rows, enough));
  ASSERT_EQ(first.size(), 3U);
  EXPECT_EQ(instructions_in(counts_of(rows, enough)), first);
  EXPECT_GT(first[0], 102U * 6U);  // the table is asked for every pixel
}

TEST(RowCounts, a_kernel_takes_fewer_instructions_than_the_whole_row) {
  const RowCounts counts = counts_of(rows_matching("^euler_number/bitpacked/baseline/1/"), 100000);
  ASSERT_EQ(counts.rows.size(), 2U);
  EXPECT_LT(counts.rows[0].instructions, counts.rows[1].instructions);
}

TEST(RowCounts, rows_with_too_many_steps_are_skipped_in_both_scopes) {
  const RowCounts counts = counts_of(rows_matching("^thin_guo_hall/bitpacked/baseline/1/"), 1000);
  EXPECT_TRUE(counts.rows.empty());
  ASSERT_EQ(counts.skipped.size(), 2U);
  EXPECT_EQ(counts.skipped[0].reason, kTooManySteps);
}

/// Ends its process in the middle of a call.
class EndingJob : public Job {
 public:
  void run(const ConstByteView&, const ByteView&) override {
    if (++calls_ == 2) std::raise(SIGKILL);
  }

 private:
  int calls_ = 0;
};

TEST(RowCounts, a_process_that_ends_early_is_a_failure_with_the_name_of_the_row) {
  TimedRow row = three_rows().front();
  Variant ending = *row.variant;
  ending.make_job = [](Index, Index, int) { return std::make_unique<EndingJob>(); };
  row.variant = &ending;
  try {
    static_cast<void>(count_of(row, 1000));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), "instructions of " + row.name +
                                " cannot be counted: the process that counts ended with signal 9");
  }
}

TEST(CountedInput, the_small_copy_has_more_than_a_word_in_a_row_and_the_middle_its_rows) {
  const TimedInput scene = std::move(timed_inputs({{}, 0}).front());
  const TimedInput small = small_copy(scene);
  EXPECT_EQ(small.name, "scene_small");
  EXPECT_EQ(small.width(), 102);
  EXPECT_EQ(small.height(), 26);
  const TimedInput middle = middle_rows(scene, 12);
  EXPECT_EQ(middle.name, "scene_12_rows");
  EXPECT_EQ(middle.grey.at(7, 0), scene.grey.at(7, 200));
  EXPECT_EQ(middle_rows(scene, 1000).height(), scene.height());
}

}  // namespace
}  // namespace thinbench
