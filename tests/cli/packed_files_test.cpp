// thinbench run on packed files: PBM, raw bits, and TIFF of 1 bit per pixel.
#include <regex>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/made_image.hpp"
#include "support/packed_image.hpp"
#include "support/tiff_bytes.hpp"
#include "typed.hpp"

namespace thinbench {
namespace {

class PackedRun : public Commands {
 protected:
  PackedRun() { put("in.pbm", header + bits(image)); }

  static std::string bits(const ByteImage& pixels, BitOrder order = BitOrder::msb_first) {
    return raw_bytes(PackedImage(pixels.view(), order));
  }

  ByteImage image = noise_image(1203, 900, 85, 16, 3);
  std::string header = "P4 1203\n# drawn\n900\n";
};

TEST_F(PackedRun, thins_pbm_in_memory) {
  const std::string text = output_of("run life in.pbm OUT.PBM --max-iterations 4");
  const std::regex line(R"(life: 1203 x 900, 4 iterations, \d+ foreground pixels before, )"
                        R"(\d+ after, \d+\.\d{3} ms\n)");
  EXPECT_TRUE(std::regex_match(text, line)) << text;
  EXPECT_TRUE(bytes_of("OUT.PBM") ==
              header + bits(thinned(Rule::named("life"), image, {.max_iterations = 4})));
}

TEST_F(PackedRun, thins_raw_bits_in_both_orders) {
  for (const auto& [order, name] :
       {std::pair{BitOrder::msb_first, "msb"}, {BitOrder::lsb_first, "lsb"}}) {
    put("raw", bits(image, order));
    output_of("run thin_zhang_suen raw raw --raw 1203x900 --bit-order " + std::string(name));
    EXPECT_TRUE(bytes_of("raw") == bits(thinned(Rule::zhang_suen, image), order)) << name;
  }
}

TEST_F(PackedRun, files_of_other_formats_are_rejected) {
  const std::string kind = "it is not a binary PBM file (P4), as OUT requires";
  const std::string damaged = "its PBM header is damaged";
  const std::string size = "; expected 1 to 2^40 pixels";
  for (const auto& [bytes, reason] : std::vector<std::pair<std::string, std::string>>{
           {"P5 2 2 255 abcd", kind},
           {"", kind},
           {"P4 12", damaged},
           {"P4 12 3x", damaged},
           {"P4 12 -3\n", "its size is 12 x -3" + size},
           {"P4 0 3\n", "its size is 0 x 3" + size},
           {"P4 9999999999 9999999999\n", "its size is 9999999999 x 9999999999" + size},
           {"P4 12 3\n12345", "it has 13 bytes; its header and 12 x 3 pixels take 14"}}) {
    put("bad.pbm", bytes);
    expect_rejected({1, "run thin_guo_hall bad.pbm out.pbm", {"cannot read 'bad.pbm': " + reason}});
  }
}

TEST_F(PackedRun, what_does_not_apply_to_packed_files_is_rejected) {
  const std::string run = "run thin_guo_hall in.pbm out.pbm ";
  const std::string grey = " does not apply to packed files, whose pixels have one bit";
  expect_rejected({
      {1, "run thin_guo_hall absent.pbm out.pbm", {"'absent.pbm': there is no such file"}},
      {2, run + "--foreground dark", {"--foreground" + grey}},
      {2, run + "--threshold 12", {"--threshold" + grey}},
      {2, run + "--raw 12x", {"--raw: expected WIDTHxHEIGHT of 1 to 2^40 pixels, got '12x'"}},
      {2, run + "--bit-order lsb", {"--raw"}},
  });
}

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
