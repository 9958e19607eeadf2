// The gate on real measurements. What is found depends on the machine, so that too noisy is
// accepted everywhere; the wrong colour is not.
#include <memory>

#include <gtest/gtest.h>

#include "paired/session.hpp"
#include "regress/compare.hpp"
#include "regress/table.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

const std::string kRow = "edges_sobel/simd_16bit/baseline/1/end_to_end/scene";

/// Does the first tenth of the rows a second time.
class Slowed final : public Job {
 public:
  Slowed(const JobMaker& maker, Index width, Index height)
      : job_(maker(width, height, 1)),
        tenth_(maker(width, height / 10 + 1, 1)),
        scratch_(width, height / 10 + 1) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    job_->run(input, output);
    ConstImageView top = input;
    top.height = scratch_.height();
    tenth_->run(top, scratch_.view());
  }

 private:
  std::unique_ptr<Job> job_;
  std::unique_ptr<Job> tenth_;
  ByteImage scratch_;
};

std::vector<Operation> with_slowed_row() {
  Operation operation = operation_of("edges_sobel");
  for (Variant& variant : operation.variants) {
    if (variant.technique != "simd_16bit" || variant.threaded) continue;
    variant.make_job = [maker = variant.make_job](Index width, Index height, int) {
      return std::make_unique<Slowed>(maker, width, height);
    };
  }
  return {operation};
}

/// Appends one process to a list of sample files.
void measure_once(const std::vector<Operation>& operations, const std::string& file,
                  std::vector<std::string>& files) {
  const Measurer here = [&](const std::string& order, std::uint64_t seed, const LineSink& answer) {
    measure(order_from(order), seed, operations, answer);
  };
  const int status =
      run_paired({"--quiet", "--filter", "^edges_sobel/(simd_16bit|simd_to_bits)/baseline/1/end",
                  "--processes", "1", "--first-seed", std::to_string(files.size()),
                  "--seconds-per-pair", "0.01", "--samples-out", file},
                 operations, here);
  EXPECT_TRUE(status == 0 || status == kInconclusive);
  files.push_back(file);
}

struct Measured {
  std::vector<std::string> before;
  std::vector<std::string> same;
  std::vector<std::string> slowed;
};

Measured by_turns(const TemporaryDirectory& folder) {
  const std::vector<Operation> plain = {operation_of("edges_sobel")};
  const std::vector<Operation> slowed = with_slowed_row();
  Measured measured;
  for (int i = 0; i < 9; ++i) {
    const std::string number = std::to_string(i);
    measure_once(plain, folder.file("before" + number), measured.before);
    measure_once(slowed, folder.file("slowed" + number), measured.slowed);
    measure_once(plain, folder.file("same" + number), measured.same);
  }
  return measured;
}

RegressionVerdict verdict_on(const std::vector<std::string>& before,
                             const std::vector<std::string>& now) {
  const MeasuredRun run = read_run(now);
  std::vector<RegressionVerdict> rows = between(read_run(before), run, {false, 2048});
  doubt(judge_controls(run, Neighbour::next_process), rows);
  for (const RegressionVerdict& row : rows) {
    if (row.name == kRow) return row;
  }
  ADD_FAILURE() << "there is no row " << kRow;
  return {};
}

TEST(GateMeasured, row_slowed_by_a_tenth_does_not_pass_and_the_same_row_does_not_fail) {
  const TemporaryDirectory folder;
  testing::internal::CaptureStderr();
  const Measured measured = by_turns(folder);
  const std::string said = testing::internal::GetCapturedStderr();
  const RegressionVerdict slowed = verdict_on(measured.before, measured.slowed);
  const RegressionVerdict same = verdict_on(measured.before, measured.same);
  EXPECT_NE(slowed.verdict, Verdict::pass) << to_table({slowed}, true) << said;
  EXPECT_NE(same.verdict, Verdict::fail) << to_table({same}, true) << said;
  RecordProperty("slowed", to_table({slowed}, true));
  RecordProperty("same", to_table({same}, true));
}

}  // namespace
}  // namespace thinbench
