// thinbench run on TIFF files of 1 bit per pixel.
#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/made_image.hpp"
#include "support/tiff_bytes.hpp"
#include "typed.hpp"

namespace thinbench {
namespace {

const std::string kRun = "run thin_guo_hall page.tif out.tif ";

class PackedTiff : public Commands {
 protected:
  PackedTiff() { write_tiff("page.tif", paper.view(), {COMPRESSION_CCITTFAX4}); }

  ByteImage ink = noise_image(1203, 900, 40, 12, 3);
  ByteImage paper = mapped(ink, [](int pixel) { return pixel == 0 ? 255 : 0; });
};

TEST_F(PackedTiff, pixels_remarks_and_summary_are_those_of_grey_images) {
  const auto until_milliseconds = [](const std::string& text) {
    return text.substr(0, text.rfind(','));
  };
  for (const std::string foreground : {"auto", "bright", "dark"}) {
    for (const int photometric : {PHOTOMETRIC_MINISWHITE, PHOTOMETRIC_MINISBLACK}) {
      for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_CCITTFAX3}) {
        write_tiff(
            "page.tif", paper.view(),
            {static_cast<std::uint16_t>(compression), static_cast<std::uint16_t>(photometric)});
        const ProgramRun packed = typed(kRun + "--foreground " + foreground);
        const ProgramRun grey =
            typed("run thin_guo_hall page.tif out.png --foreground " + foreground);
        ASSERT_EQ(packed.status, 0) << packed.err;
        EXPECT_EQ(packed.err, grey.err);
        EXPECT_EQ(until_milliseconds(packed.out), until_milliseconds(grey.out));
        expect_image("out.tif", read_grey("out.png"));
      }
    }
  }
}

TEST_F(PackedTiff, output_has_one_bit_per_pixel_and_the_compression_of_the_input) {
  output_of(kRun);
  EXPECT_EQ(tiff_tag("out.tif", TIFFTAG_BITSPERSAMPLE), 1);
  EXPECT_EQ(tiff_tag("out.tif", TIFFTAG_COMPRESSION), COMPRESSION_CCITTFAX4);
  expect_image("out.tif", thinned(Rule::guo_hall, ink));
  EXPECT_EQ(names(), (Names{"out.tif", "page.tif"}));
}

TEST_F(PackedTiff, extension_may_be_in_capitals_and_the_input_may_be_replaced) {
  fs::rename("page.tif", "A.TIFF");
  output_of("run thin_guo_hall A.TIFF A.TIFF");
  EXPECT_EQ(tiff_tag("A.TIFF", TIFFTAG_BITSPERSAMPLE), 1);
  expect_image("A.TIFF", thinned(Rule::guo_hall, ink));
}

TEST_F(PackedTiff, other_tiff_images_remain_grey) {
  output_of(kRun + "--threshold 100");
  EXPECT_EQ(tiff_tag("out.tif", TIFFTAG_BITSPERSAMPLE), 8);
  write_tiff("page.tif", ink.view(), {.tile = 64});
  output_of(kRun);
  EXPECT_EQ(tiff_tag("out.tif", TIFFTAG_BITSPERSAMPLE), 8);
}

TEST_F(PackedTiff, damaged_file_is_one_line_and_leaves_nothing) {
  std::string damaged = bytes_of("page.tif");
  for (std::size_t i = 100; i < 200; ++i) damaged[i] = '\0';
  for (const auto& [content, reason] :
       {std::pair{damaged, " at line "},
        {plain_tiff(99, 9, 0, 1, "abc"), "truncated"},
        {plain_tiff(4'000'000'000, 1000, 0, 1, ""), "it has more than 2^40 pixels"}}) {
    put("page.tif", content);
    testing::internal::CaptureStderr();
    expect_rejected({1, kRun + "--max-iterations 3", {"cannot read 'page.tif': ", reason}});
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  }
}

}  // namespace
}  // namespace thinbench
