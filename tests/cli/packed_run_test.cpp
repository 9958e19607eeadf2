// thinbench run on packed files.
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "program_run.hpp"
#include "support/packed_image.hpp"
#include "support/temporary_directory.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

using Names = std::set<std::string>;

constexpr Index kWidth = 1203;
constexpr Index kHeight = 900;

class PackedRun : public testing::Test {
 protected:
  [[nodiscard]] std::string expected(const Rule& rule, BitOrder order,
                                     const Thinning& thinning = {}) const {
    ByteImage skeleton(kWidth, kHeight);
    thin(rule, image.view(), skeleton.view(), thinning);
    return raw_bytes(PackedImage(skeleton.view(), order));
  }

  ByteImage image = noise_image(kWidth, kHeight, 85, 16, 3);
  std::string header = "P4 1203\n# drawn\n900\n";
  TemporaryDirectory directory;
  std::string pbm =
      directory.with("in.pbm", header + raw_bytes(PackedImage(image.view(), BitOrder::msb_first)));
  std::string out = directory.file("out.pbm");
};

TEST_F(PackedRun, thins_pbm_in_memory) {
  const ProgramRun run = run_with({"run", "thin_guo_hall", pbm, out, "--max-iterations", "4"});
  EXPECT_EQ(run.status, 0) << run.err;
  const std::regex line(R"(thin_guo_hall: 1203 x 900, 4 iterations, \d+ foreground pixels before, )"
                        R"(\d+ after, \d+\.\d{3} ms\n)");
  EXPECT_TRUE(std::regex_match(run.out, line)) << run.out;
  EXPECT_TRUE(bytes_of(out) ==
              header + expected(Rule::guo_hall, BitOrder::msb_first, {.max_iterations = 4}));
}

TEST_F(PackedRun, extension_in_capitals_is_that_of_pbm) {
  const std::string capitals = directory.file("OUT.PBM");
  EXPECT_EQ(run_with({"run", "thin_guo_hall", pbm, capitals}).status, 0);
  EXPECT_TRUE(bytes_of(capitals) == header + expected(Rule::guo_hall, BitOrder::msb_first));
}

TEST_F(PackedRun, thins_pbm_out_of_core) {
  const ProgramRun run = run_with({"run", "thin_mb2", pbm, out, "--out-of-core", "--memory", "1M",
                                   "--threads", "8", "--border", "keep"});
  EXPECT_EQ(run.status, 0) << run.err;
  const std::regex lines(R"(thin_mb2/out-of-core/8: 1203 x 900, \d+ iterations, \d+ foreground )"
                         R"(pixels before, \d+ after, \d+\.\d{3} ms\n)"
                         R"(\d+ tiles of \d+ x \d+ in \d+ passes\n)");
  EXPECT_TRUE(std::regex_match(run.out, lines)) << run.out;
  EXPECT_TRUE(bytes_of(out) ==
              header + expected(Rule::mb2, BitOrder::msb_first, {.border = Border::keep}));
  EXPECT_EQ(directory.names(), (Names{"in.pbm", "out.pbm"}));
}

TEST_F(PackedRun, thins_raw_bits_in_both_orders_in_memory_and_out_of_core) {
  for (const BitOrder order : {BitOrder::msb_first, BitOrder::lsb_first}) {
    const std::string raw = directory.with("raw", raw_bytes(PackedImage(image.view(), order)));
    const std::string name = order == BitOrder::msb_first ? "msb" : "lsb";
    std::vector<std::string> words = {"run",   "thin_zhang_suen", raw,           raw,
                                      "--raw", "1203x900",        "--bit-order", name};
    EXPECT_EQ(run_with(words).status, 0);
    const std::string skeleton = expected(Rule::zhang_suen, order);
    EXPECT_TRUE(bytes_of(raw) == skeleton) << name;
    const std::string again = directory.with("raw", raw_bytes(PackedImage(image.view(), order)));
    words.insert(words.end(), {"--out-of-core", "--memory", "1M"});
    EXPECT_EQ(run_with(words).status, 0);
    EXPECT_TRUE(bytes_of(again) == skeleton) << name << " out of core";
  }
}

TEST_F(PackedRun, files_of_other_formats_are_rejected) {
  const auto failure = [&](const std::string& bytes) {
    const std::string file = directory.with("bad", bytes);
    return failure_of({"run", "thin_guo_hall", file, out}, 1)
        .substr(("cannot read '" + file + "': ").size());
  };
  EXPECT_EQ(failure("P5 2 2 255 abcd"), "it is not a binary PBM file (P4)");
  EXPECT_EQ(failure(""), "it is not a binary PBM file (P4)");
  EXPECT_EQ(failure("P4 12"), "its PBM header is damaged");
  EXPECT_EQ(failure("P4 12 -3\n"), "its size is 12 x -3; expected 1 to 2^40 pixels");
  EXPECT_EQ(failure("P4 12 3x"), "its PBM header is damaged");
  EXPECT_EQ(failure("P4 0 3\n"), "its size is 0 x 3; expected 1 to 2^40 pixels");
  EXPECT_EQ(failure("P4 9999999999 9999999999\n"),
            "its size is 9999999999 x 9999999999; expected 1 to 2^40 pixels");
  EXPECT_EQ(failure("P4 12 3\n12345"), "it has 13 bytes; 12 x 3 pixels take 14");
  EXPECT_EQ(failure_of({"run", "thin_guo_hall", "absent.pbm", out}, 1),
            "cannot read 'absent.pbm': there is no such file");
  EXPECT_EQ(directory.names(), (Names{"bad", "in.pbm"}));
}

TEST_F(PackedRun, options_that_do_not_apply_are_rejected) {
  const auto failure = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"run", "thin_guo_hall", pbm, out});
    return failure_of(more, 2);
  };
  EXPECT_EQ(failure({"--foreground", "dark"}),
            "--foreground does not apply to packed files, whose pixels have one bit");
  EXPECT_EQ(failure({"--threshold", "12"}),
            "--threshold does not apply to packed files, whose pixels have one bit");
  EXPECT_EQ(failure({"--raw", "12x"}),
            "--raw: expected WIDTHxHEIGHT of at most 2^40 pixels, got '12x'");
  for (const std::string memory : {"0", "1023K", "12Q", "M", "99999999999T"}) {
    EXPECT_EQ(
        failure({"--out-of-core", "--memory", memory}),
        "--memory: expected a number of bytes from 1M, such as 256M or 4G, got '" + memory + "'");
  }
  EXPECT_NE(failure({"--memory", "1G"}).find("--out-of-core"), std::string::npos);
  EXPECT_NE(failure({"--resume"}).find("--out-of-core"), std::string::npos);
  EXPECT_NE(failure({"--bit-order", "lsb"}).find("--raw"), std::string::npos);
  EXPECT_EQ(directory.names(), Names{"in.pbm"});
}

TEST_F(PackedRun, sequential_rules_do_not_run_out_of_core) {
  EXPECT_EQ(failure_of({"run", "thin_spta", pbm, out, "--out-of-core"}, 1),
            "thin_spta cannot run on tiles; only rules that compute all pixels of a sub-iteration "
            "from the same image can");
}

}  // namespace
}  // namespace thinbench
