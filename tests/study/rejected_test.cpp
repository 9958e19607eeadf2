#include <gtest/gtest.h>

#include "images/image_file.hpp"
#include "program_run.hpp"
#include "support/isa_cap.hpp"
#include "support/own_directory.hpp"

namespace thinbench {
namespace {

struct Rejected {
  std::string line;  // "''" is an empty word
  int status;
  std::string said;
};

const std::vector<Rejected> kRejected = {
    {"train", 2,
     "train needs one more word: two-layer or cluster; see 'thinbench-study train --help'"},
    {"train two-layers", 2, "no command is named 'two-layers'; did you mean 'two-layer'?"},
    {"train two-layer --sead 2", 2, "there is no option '--sead'; did you mean '--seed'? See"},
    {"train --seed 2 two-layer", 2,
     "there is no option '--seed'; see 'thinbench-study train --help'"},
    {"train cluster more", 2,
     "'more' was not expected; see 'thinbench-study train cluster --help'"},
    {"train cluster --out ''", 2, "--out: expected a value, got ''; see"},
    {"train cluster --out no_such_directory/a", 1, "there is no directory 'no_such_directory'"},
    {"train cluster --header no_such_directory/a", 1, "cannot write 'no_such_directory/a'"},
    {"train cluster --max-nets 11", 1, "the rule needs 12 nets; --max-nets allows 11"},
    {"train cluster --max-nets 0", 2, "--max-nets: expected an integer in [1, 16], got '0'; see"},
    {"train two-layer --hidden 1 --max-restarts 0", 1, "training reached "},
    {"train two-layer --hidden 65", 2, "--hidden: expected an integer in [1, 64], got '65'; see"},
    {"train two-layer --hidden 10 --out a.json", 2,
     "weights files hold nets of 8 hidden neurons, not 10"},
    {"train two-layer --seed -1", 2, "[0, 18446744073709551615], got '-1'"},
    // With these options the training itself would fail with another error.
    {"train two-layer --seed 5 --max-restarts 0 --out no_such_directory/a", 1, "no directory"},
    {"train two-layer --seed 5 --max-restarts 0 --markdown no_such_directory/a", 1, "no directory"},
    {"experiment nothing", 2,
     "known: edge-quality, literal-holes, cluster-runs, quantisation, hidden-neurons, quality and "
     "operation-counts"},
    {"experiment quantisation --quick", 2, "there is no option '--quick'; see"},
    {"experiment quality --foreground dark", 2, "--foreground requires --image; see"},
    {"experiment quality --image absent.png", 1, "cannot read 'absent.png': there is no such file"},
    {"experiment hidden-neurons --out no_such_directory/x.json", 1,
     "cannot write 'no_such_directory/x.json': there is no directory 'no_such_directory'"},
    {"verify --foreground dark", 2, "--foreground requires --image; see"},
    {"verify --image absent.png", 1, "cannot read 'absent.png': there is no such file"},
    {"verify --filter (", 2, "--filter: '(' is not a regular"},
    {"verify --threads 0", 2, "--threads: expected an integer in [1, 1024], got '0'; see"},
    {"instructions --foreground dark", 2, "--foreground requires --image; see"},
    {"instructions --image absent.png", 1, "cannot read 'absent.png': there is no such file"},
    {"instructions --filter ^euler_number/reference/", 2,
     "filter '^euler_number/reference/' matches only references or rows with threads"},
    {"instructions --filter ^euler_number/.*/avx2/", 2,
     "filter '^euler_number/.*/avx2/' is skipped: "},
    {"circuits mb2", 2, "mb2"},
    {"run holes absent.png out.png", 1, "cannot read 'absent.png': there is no such file"},
    {"run thin_guo a.png out.png", 2,
     "no operation is named 'thin_guo'; did you mean 'thin_guo_hall'?"},
    {"run holes a.png out.png --technique lut", 2,
     "there is no variant of lut, only union_find, bitpacked_runs, simd_runs"},
    {"run thin_guo_hall a.png out.png --technique lut --isa sse4.2", 2,
     "there is no variant for sse4.2, only baseline"},
    {"run thin_guo_hall a.png out.png --technique lut_sliding --threads 2", 2,
     "there is no variant on 2 threads, only on one"},
    {"run holes a.png out.png", 2, "holes gives no image"},
    {"run thin_guo_hall a.png out.png --technique simd_bitpacked_row", 1,
     "simd_bitpacked_row/avx512"},
    {"scene", 2, "scene needs OUT, an image to write, or --truth"},
    {"scene a.png --scale 0", 2, "--scale: expected an integer in [1, 100], got '0'; see"},
    {"scene a.png --noise nan", 2, "--noise: expected a number in [0, 255], got 'nan'; see"},
    {"scene a.xyz", 2, "cannot write 'a.xyz'"},
};

using StudyProgram = OwnDirectory;

TEST_F(StudyProgram, rejects_what_cannot_be_in_one_line_and_writes_nothing) {
  const IsaCap cap("baseline");
  if (!cap.is_in_force()) GTEST_SKIP() << kCapWasRead;
  write_grey("a.png", ByteImage(9, 9).view());
  for (const Rejected& one : kRejected) {
    const std::string text = failure_of(words_of(one.line), one.status);
    EXPECT_NE(text.find(one.said), std::string::npos) << one.line << ": " << text;
    EXPECT_EQ(names(), Names{"a.png"}) << one.line;
  }
}

}  // namespace
}  // namespace thinbench
