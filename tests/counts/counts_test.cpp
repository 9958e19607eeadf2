// Counts of instructions: of the rows of the study, and by single steps.
#include <array>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "counts/counted_job.hpp"
#include "counts/row_counts.hpp"
#include "counts/single_steps.hpp"
#include "thinbench/isa.hpp"

namespace thinbench {
namespace {

/// From the middle, as a step takes microseconds.
ByteImage six_rows_of(const ByteImage& image) {
  const ConstImageView all = image.view();
  return copy_of({all.row(10), all.width, 6, all.stride});
}

const std::vector<TimedInput>& small_inputs() {
  static const std::vector<TimedInput> inputs = [] {
    std::vector<TimedInput> few = timed_inputs({});
    const TimedInput small = small_copy(few.front());
    few.front() = {"six_rows", six_rows_of(small.binary), six_rows_of(small.grey)};
    return few;
  }();
  return inputs;
}

std::vector<TimedRow> rows_matching(const std::string& filter) {
  Selection selection = select_rows({.filter = filter}, all_operations(), small_inputs());
  std::erase_if(selection.rows, [](const TimedRow& row) { return row.variant == nullptr; });
  return std::move(selection.rows);
}

/// As on a machine without valgrind, while it lives.
class PathWithoutValgrind {
 public:
  PathWithoutValgrind() { setenv("PATH", "/nowhere", 1); }
  ~PathWithoutValgrind() { setenv("PATH", before_.c_str(), 1); }
  PathWithoutValgrind(const PathWithoutValgrind&) = delete;
  PathWithoutValgrind& operator=(const PathWithoutValgrind&) = delete;

 private:
  std::string before_ = std::getenv("PATH");
};

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
  const PathWithoutValgrind path;
  const RowCounts counts = counts_of(rows_matching("^thin_guo_hall/bitpacked/baseline/1/"), 1000);
  EXPECT_TRUE(counts.rows.empty());
  ASSERT_EQ(counts.skipped.size(), 2U);
  EXPECT_EQ(counts.skipped[0].reason, kTooManySteps);
}

std::vector<TimedRow> short_rows() {
  std::vector<TimedRow> rows =
      rows_matching("^(euler_number|edges_sobel|holes)/.*/(baseline|sse4.2|avx2)/1/");
  std::erase_if(rows, [](const TimedRow& row) { return !callgrind_knows(row); });
  return rows;
}

TEST(RowCounts, callgrind_counts_what_single_steps_count) {
  const std::vector<TimedRow> rows = short_rows();
  const RowCounts counts = counts_of(rows, 1000000);
  if (counts.callgrind.version.empty()) GTEST_SKIP() << counts.callgrind.why_not;
  EXPECT_EQ(counts.callgrind.why_not, "");
  ASSERT_EQ(counts.rows.size(), rows.size());
  for (const RowCount& count : counts.rows) {
    EXPECT_EQ(count.method, Method::callgrind) << count.row->name;
    const auto steps = static_cast<double>(count_of(*count.row, 1000000).value_or(0));
    EXPECT_NEAR(static_cast<double>(count.instructions), steps, 0.01 * steps) << count.row->name;
  }
}

TEST(RowCounts, single_steps_count_where_valgrind_is_missing_and_say_so) {
  const PathWithoutValgrind path;
  const RowCounts counts = counts_of(rows_matching("^euler_number/bitpacked/baseline/1/"), 100000);
  EXPECT_NE(counts.callgrind.why_not, "");
  EXPECT_EQ(counts.callgrind.version, "");
  ASSERT_EQ(counts.rows.size(), 2U);
  EXPECT_EQ(counts.rows[0].method, Method::single_steps);
}

TEST(RowCounts, callgrind_is_left_alone_where_only_avx512_is_asked_for) {
  if (!isa_available(Isa::avx512)) GTEST_SKIP() << "this machine lacks avx512";
  const PathWithoutValgrind path;
  const RowCounts counts =
      counts_of(rows_matching("^euler_number/simd_bitpacked/avx512/1/"), 100000);
  EXPECT_EQ(counts.callgrind.why_not, "");
  ASSERT_EQ(counts.rows.size(), 2U);
  EXPECT_EQ(counts.rows[0].method, Method::single_steps);
}

/// Ends its process in the middle of a call.
class EndingJob : public Job {
 public:
  void run(const ConstImageView&, const ImageView&) override {
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

TimedInput small_scene() {
  return small_copy(timed_inputs({}).front());
}

TEST(CountedJob, what_is_read_is_what_was_written) {
  const TimedInput input = small_scene();
  std::stringstream stream;
  write_job(stream, input, {"a/b", "c"});
  const CountedJob job = read_job(stream);
  EXPECT_EQ(job.rows, (std::vector<std::string>{"a/b", "c"}));
  EXPECT_EQ(job.input.name, "scene_small");
  EXPECT_TRUE(equal(job.input.binary.view(), input.binary.view()));
  EXPECT_TRUE(equal(job.input.grey.view(), input.grey.view()));
}

TEST(CountedJob, a_job_that_was_cut_off_is_rejected) {
  std::stringstream stream;
  write_job(stream, small_scene(), {"a/b"});
  const std::string whole = stream.str();
  for (const std::size_t length : {std::size_t{0}, std::size_t{20}, whole.size() - 1}) {
    std::istringstream cut(whole.substr(0, length));
    EXPECT_THROW(static_cast<void>(read_job(cut)), std::runtime_error) << length;
  }
}

constexpr std::uint64_t kEnough = 1000000;

/// Two instructions a turn, and two round them.
void turn(std::uint64_t turns) {
  asm volatile(
      "mov %0, %%rcx\n\t"
      "0: dec %%rcx\n\t"
      "jnz 0b\n\t"
      "nop"
      :
      : "r"(turns)
      : "rcx", "cc");
}

std::uint64_t instructions_of_turns(std::uint64_t turns) {
  return instructions_of([=] { turn(turns); }, kEnough).value_or(0);
}

TEST(SingleSteps, an_empty_call_has_no_instructions) {
  EXPECT_EQ(instructions_of([] {}, kEnough), 0U);
}

TEST(SingleSteps, a_loop_grows_by_its_instructions_for_each_turn) {
  const std::uint64_t once = instructions_of_turns(1);
  EXPECT_GE(once, 4U);
  EXPECT_EQ(instructions_of_turns(2), once + 2);
  EXPECT_EQ(instructions_of_turns(1001), once + 2000);
}

TEST(SingleSteps, an_instruction_that_repeats_itself_counts_once) {
  static std::array<char, 1000> from{};
  static std::array<char, 1000> to{};
  std::size_t count = 10;
  const auto copy = [&] {
    std::size_t bytes = count;
    void* source = from.data();
    void* destination = to.data();
    asm volatile("rep movsb" : "+D"(destination), "+S"(source), "+c"(bytes) : : "memory");
  };
  const auto some = instructions_of(copy, kEnough);
  count = from.size();
  EXPECT_EQ(instructions_of(copy, kEnough), some);
  EXPECT_LT(some.value_or(kEnough), 40U);
}

TEST(SingleSteps, a_call_with_too_many_steps_is_finished_and_not_counted) {
  bool finished = false;
  const auto call = [&] {
    turn(100000);
    finished = true;
  };
  EXPECT_EQ(instructions_of(call, 1000), std::nullopt);
  EXPECT_TRUE(finished);
  EXPECT_EQ(instructions_of([] {}, kEnough), 0U);
}

}  // namespace
}  // namespace thinbench
