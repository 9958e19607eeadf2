#include <gtest/gtest.h>

#include "images/image_file.hpp"
#include "program_run.hpp"
#include "support/filled_image.hpp"
#include "support/temporary_directory.hpp"
#include "support/variant_of.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

ByteImage bar(Index width = 90) {
  ByteImage image(width, 40);
  for (Index y = 10; y < 30; ++y) {
    for (Index x = 5; x < width - 5; ++x) image.at(x, y) = 255;
  }
  return image;
}

class StudyRun : public testing::Test {
 protected:
  void SetUp() override { write_grey(in, bar().view()); }

  [[nodiscard]] ProgramRun run(const std::string& operation, std::vector<std::string> more) const {
    more.insert(more.begin(), {"run", operation, in, out, "--threshold", "128"});
    return run_with(more);
  }

  TemporaryDirectory directory;
  std::string in = directory.file("in.png");
  std::string out = directory.file("out.png");
};

TEST_F(StudyRun, computes_the_pixels_of_the_library_by_the_requested_variant) {
  ByteImage expected = bar();
  thin(Rule::guo_hall, expected.view(), expected.view());
  for (const std::string technique : {"lut", "bitpacked", "simd_bitpacked"}) {
    const ProgramRun ran = run("thin_guo_hall", {"--technique", technique, "--isa", "baseline"});
    EXPECT_EQ(ran.out.find("thin_guo_hall/" + technique + "/baseline/1: 90 x 40, iterations: "), 0U)
        << ran.out << ran.err;
    EXPECT_TRUE(equal(read_grey(out).view(), expected.view())) << technique;
  }
  EXPECT_EQ(
      run("thin_guo_hall", {"--technique", "bitpacked", "--isa", "baseline", "--threads", "3"})
          .out.find("thin_guo_hall/bitpacked/baseline/3: "),
      0U);
  EXPECT_TRUE(equal(read_grey(out).view(), expected.view()));
}

TEST_F(StudyRun, takes_what_the_library_takes_by_default) {
  const auto& chosen = chosen_variant(Rule::guo_hall, 90, 40);
  const std::string name = "thin_guo_hall/" + std::string(chosen.technique) + "/" +
                           std::string(isa_name(chosen.isa)) + "/1: ";
  const ProgramRun ran = run("thin_guo_hall", {});
  EXPECT_EQ(ran.out.find(name), 0U) << ran.out << ran.err;
}

TEST_F(StudyRun, takes_cases_grey_images_and_other_projects_code) {
  ByteImage expected = bar();
  thin(Rule::zhang_suen, expected.view(), expected.view(), {.border = Border::keep});
  EXPECT_EQ(run("thin_zhang_suen:keep", {"--technique", "opencv"}).status, 0);
  EXPECT_TRUE(equal(read_grey(out).view(), expected.view()));
  ByteImage edges(90, 40);
  detect_edges(EdgeOperator::sobel, bar().view(), edges.view());
  EXPECT_EQ(run("edges_sobel", {"--technique", "simd_16bit", "--isa", "baseline"}).status, 0);
  EXPECT_TRUE(equal(read_grey(out).view(), edges.view()));
}

}  // namespace
}  // namespace thinbench
