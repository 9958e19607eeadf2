#include <gtest/gtest.h>

#include "typed.hpp"

namespace thinbench {
namespace {

using StudyProgram = Commands;

TEST_F(StudyProgram, rejects_what_cannot_be_in_one_line_and_writes_nothing) {
  const IsaCap cap("baseline");
  if (!cap.is_in_force()) GTEST_SKIP() << kCapWasRead;
  write_grey("a.png", ByteImage(9, 9).view());
  const std::string absent = "cannot read 'absent.png': there is no such file";
  const std::string image = "--foreground requires --image; see";
  const std::string range = ": expected an integer in ";
  expect_rejected({
      {2,
       "train",
       {"train needs one more word: two-layer or cluster; see 'thinbench-study train --help'"}},
      {2, "train two-layers", {"no command is named 'two-layers'; did you mean 'two-layer'?"}},
      {2, "train two-layer --sead 2", {"there is no option '--sead'; did you mean '--seed'? See"}},
      {2,
       "train --seed 2 two-layer",
       {"there is no option '--seed'; see 'thinbench-study train --help'"}},
      {2,
       "train cluster more",
       {"'more' was not expected; see 'thinbench-study train cluster --help'"}},
      {2, "train cluster --out ''", {"--out: expected a value, got ''; see"}},
      {1, "train cluster --out no/a", {"there is no directory 'no'"}},
      {1, "train cluster --header no/a", {"cannot write 'no/a'"}},
      {1, "train cluster --max-nets 11", {"the rule needs 12 nets; --max-nets allows 11"}},
      {2, "train cluster --max-nets 0", {"--max-nets" + range + "[1, 16], got '0'; see"}},
      {1, "train two-layer --hidden 1 --max-restarts 0", {"training reached "}},
      {2, "train two-layer --hidden 65", {"--hidden" + range + "[1, 64], got '65'; see"}},
      {2,
       "train two-layer --hidden 10 --out a.json",
       {"weights files hold nets of 8 hidden neurons, not 10"}},
      {2, "train two-layer --seed -1", {"[0, 18446744073709551615], got '-1'"}},
      // With these options the training itself would fail with another error.
      {1, "train two-layer --seed 5 --max-restarts 0 --out no/a", {"no directory"}},
      {1, "train two-layer --seed 5 --max-restarts 0 --markdown no/a", {"no directory"}},
      {2,
       "experiment nothing",
       {"known: edge-quality, literal-holes, cluster-runs, quantisation, hidden-neurons, quality "
        "and operation-counts"}},
      {2, "experiment quantisation --quick", {"there is no option '--quick'; see"}},
      {2, "experiment quality --foreground dark", {image}},
      {1, "experiment quality --image absent.png", {absent}},
      {1,
       "experiment hidden-neurons --out no/x.json",
       {"cannot write 'no/x.json': there is no directory 'no'"}},
      {2, "verify --foreground dark", {image}},
      {1, "verify --image absent.png", {absent}},
      {2, "verify --filter (", {"--filter: '(' is not a regular"}},
      {2, "verify --threads 0", {"--threads" + range + "[1, 1024], got '0'; see"}},
      {2, "instructions --foreground dark", {image}},
      {1, "instructions --image absent.png", {absent}},
      {2,
       "instructions --filter ^euler_number/reference/",
       {"filter '^euler_number/reference/' matches only references or rows with threads"}},
      {2,
       "instructions --filter ^euler_number/.*/avx2/",
       {"filter '^euler_number/.*/avx2/' is skipped: "}},
      {2, "circuits mb2", {"mb2"}},
      {1, "run holes absent.png out.png", {absent}},
      {2,
       "run thin_guo a.png out.png",
       {"no operation is named 'thin_guo'; did you mean 'thin_guo_hall'?"}},
      {2,
       "run holes a.png out.png --technique lut",
       {"there is no variant of lut, only union_find, bitpacked_runs, simd_runs"}},
      {2,
       "run thin_guo_hall a.png out.png --technique lut --isa sse4.2",
       {"there is no variant for sse4.2, only baseline"}},
      {2,
       "run thin_guo_hall a.png out.png --technique lut_sliding --threads 2",
       {"there is no variant on 2 threads, only on one"}},
      {2, "run holes a.png out.png", {"holes gives no image"}},
      {1,
       "run thin_guo_hall a.png out.png --technique simd_bitpacked_row",
       {"simd_bitpacked_row/avx512"}},
      {2, "scene", {"scene needs OUT, an image to write, or --truth"}},
      {2, "scene a.png --scale 0", {"--scale" + range + "[1, 100], got '0'; see"}},
      {2, "scene a.png --noise nan", {"--noise: expected a number in [0, 255], got 'nan'; see"}},
      {2, "scene a.xyz", {"cannot write 'a.xyz'"}},
  });
}

}  // namespace
}  // namespace thinbench
