// thinbench run on TIFF files of 1 bit per pixel.
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "images/image_file.hpp"
#include "program_run.hpp"
#include "support/file_size_limit.hpp"
#include "support/temporary_directory.hpp"
#include "support/tiff_bytes.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

using Names = std::set<std::string>;

constexpr Index kWidth = 1203;
constexpr Index kHeight = 900;

ByteImage inverted(const ByteImage& image) {
  ByteImage result(image.width(), image.height());
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) result.at(x, y) = image.at(x, y) == 0 ? 255 : 0;
  }
  return result;
}

class PackedTiff : public testing::Test {
 protected:
  PackedTiff() { write_tiff(page, inverted(ink).view(), {COMPRESSION_CCITTFAX4}); }

  [[nodiscard]] static ByteImage thinned(const ByteImage& image) {
    ByteImage skeleton(image.width(), image.height());
    thin(Rule::guo_hall, image.view(), skeleton.view());
    return skeleton;
  }

  [[nodiscard]] ProgramRun run(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"run", "thin_guo_hall", page, out});
    return run_with(more);
  }

  ByteImage ink = noise_image(kWidth, kHeight, 40, 12, 3);
  TemporaryDirectory directory;
  std::string page = directory.file("page.tif");  // dark ink on bright paper
  std::string out = directory.file("out.tif");
};

TEST_F(PackedTiff, pixels_remarks_and_summary_are_those_of_grey_images) {
  const std::string png = directory.file("out.png");
  const auto until_milliseconds = [](const std::string& text) {
    return text.substr(0, text.rfind(','));
  };
  for (const std::string foreground : {"auto", "bright", "dark"}) {
    for (const int photometric : {PHOTOMETRIC_MINISWHITE, PHOTOMETRIC_MINISBLACK}) {
      for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_CCITTFAX3}) {
        write_tiff(
            page, inverted(ink).view(),
            {static_cast<std::uint16_t>(compression), static_cast<std::uint16_t>(photometric)});
        const ProgramRun packed = run({"--foreground", foreground});
        const ProgramRun grey =
            run_with({"run", "thin_guo_hall", page, png, "--foreground", foreground});
        ASSERT_EQ(packed.status, 0) << packed.err;
        EXPECT_EQ(packed.err, grey.err);
        EXPECT_EQ(until_milliseconds(packed.out), until_milliseconds(grey.out));
        EXPECT_TRUE(equal(read_grey(out).view(), read_grey(png).view())) << foreground;
      }
    }
  }
}

TEST_F(PackedTiff, output_has_one_bit_per_pixel_and_the_compression_of_the_input) {
  ASSERT_EQ(run().status, 0);
  EXPECT_EQ(tiff_tag(out, TIFFTAG_BITSPERSAMPLE), 1);
  EXPECT_EQ(tiff_tag(out, TIFFTAG_COMPRESSION), COMPRESSION_CCITTFAX4);
  EXPECT_TRUE(equal(read_grey(out).view(), thinned(ink).view()));
  EXPECT_EQ(directory.names(), (Names{"out.tif", "page.tif"}));
}

TEST_F(PackedTiff, extension_may_be_in_capitals_and_the_input_may_be_replaced) {
  const std::string file = directory.with("A.TIFF", bytes_of(page));
  ASSERT_EQ(run_with({"run", "thin_guo_hall", file, file}).status, 0);
  EXPECT_EQ(tiff_tag(file, TIFFTAG_BITSPERSAMPLE), 1);
  EXPECT_TRUE(equal(read_grey(file).view(), thinned(ink).view()));
}

TEST_F(PackedTiff, other_tiff_images_remain_grey) {
  const std::string threshold = "--threshold";
  EXPECT_EQ(run({threshold, "100"}).status, 0);
  EXPECT_EQ(tiff_tag(out, TIFFTAG_BITSPERSAMPLE), 8);
  write_tiff(page, ink.view(), {.tile = 64});
  EXPECT_EQ(run().status, 0);
  EXPECT_EQ(tiff_tag(out, TIFFTAG_BITSPERSAMPLE), 8);
}

TEST_F(PackedTiff, thins_out_of_core) {
  for (const std::string foreground : {"auto", "bright"}) {
    const ProgramRun result =
        run({"--out-of-core", "--memory", "1M", "--threads", "8", "--foreground", foreground});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find(" tiles of "), std::string::npos) << result.out;
    EXPECT_EQ(tiff_tag(out, TIFFTAG_COMPRESSION), COMPRESSION_CCITTFAX4);
    const ByteImage expected = foreground == "auto" ? thinned(ink) : thinned(inverted(ink));
    EXPECT_TRUE(equal(read_grey(out).view(), expected.view())) << foreground;
    EXPECT_EQ(directory.names(), (Names{"out.tif", "page.tif"}));
  }
}

TEST_F(PackedTiff, damaged_file_is_one_line_and_leaves_nothing) {
  const std::string bytes = bytes_of(page);
  std::string damaged = bytes;
  for (std::size_t i = 100; i < 200; ++i) damaged[i] = '\0';
  for (const auto& [content, reason] :
       {std::pair{damaged, std::string(" at line ")},
        {plain_tiff(99, 9, 0, 1, "abc"), "truncated"},
        {plain_tiff(4'000'000'000, 1000, 0, 1, ""), "expected 1 to 2^40 pixels"}}) {
    const std::string bad = directory.with("bad.tif", content);
    for (const std::string option : {"--max-iterations=3", "--out-of-core"}) {
      testing::internal::CaptureStderr();
      const std::string error = failure_of({"run", "thin_guo_hall", bad, out, option}, 1);
      EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
      EXPECT_TRUE(error.starts_with("cannot read '" + bad + "': ")) << error;
      EXPECT_NE(error.find(reason), std::string::npos) << error;
      EXPECT_EQ(directory.names(), (Names{"bad.tif", "page.tif"}));
    }
  }
}

TEST_F(PackedTiff, full_disk_is_one_line_and_leaves_nothing) {
  const FileSizeLimit limit(1000);
  EXPECT_EQ(failure_of({"run", "thin_guo_hall", page, out, "--foreground", "dark"}, 1),
            "cannot write '" + out + "': File too large");
  EXPECT_EQ(directory.names(), Names{"page.tif"});
}

TEST_F(PackedTiff, what_does_not_run_out_of_core_is_rejected) {
  const std::string tiled = directory.file("tiled.tif");
  write_tiff(tiled, ink.view(), {.tile = 64});
  EXPECT_EQ(failure_of({"run", "thin_guo_hall", tiled, out, "--out-of-core"}, 1),
            "cannot read '" + tiled + "': it is not a TIFF image of 1 bit per pixel in strips");
  EXPECT_EQ(failure_of({"run", "thin_guo_hall", page, out, "--out-of-core", "--threshold", "3"}, 2),
            "--threshold does not apply to packed files, whose pixels have one bit");
  const ByteImage large = noise_image(4000, 4000, 50, 1, 3);
  write_tiff(page, large.view(),
             {COMPRESSION_LZW, PHOTOMETRIC_MINISBLACK, FILLORDER_MSB2LSB, 4000});
  EXPECT_NE(failure_of({"run", "thin_guo_hall", page, out, "--out-of-core", "--memory", "1M"}, 1)
                .find("reading it takes "),
            std::string::npos);
}

}  // namespace
}  // namespace thinbench
