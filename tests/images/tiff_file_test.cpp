// Images of 1 bit per pixel: PBM headers, and TIFF read and written by rows.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "harness/splitmix64.hpp"
#include "harness/test_images.hpp"
#include "images/binarise.hpp"
#include "images/image_file.hpp"
#include "images/pnm.hpp"
#include "images/tiff.hpp"
#include "support/file_size_limit.hpp"
#include "support/made_image.hpp"
#include "support/own_directory.hpp"
#include "support/packed_image.hpp"
#include "support/rejection.hpp"
#include "support/tiff_bytes.hpp"

namespace thinbench {
namespace {

/// The rows of an image that stays packed.
std::string rows_of(const std::string& path) {
  const auto page = decode_packed_tiff(read_file(path));
  if (!page) return "not packed";
  const Pixels& pixels = page->pixels;
  return {pixels.row(0), pixels.row(0) + pixels.height * pixels.row_bytes()};
}

TiffFormat format_of(const std::string& path) {
  return decode_packed_tiff(read_file(path)).value().format;
}

void write_rows(const std::string& path, const TiffFormat& format, Index width, Index height,
                const std::string& rows) {
  const Samples page = {rows.data(), width, height, packed_row_bytes(width), 1, SampleKind::bit};
  write_bytes(path, encode_tiff({&page, 1}, format));
}

/// The rows of the image as they are read.
std::string bits_of(const ByteImage& image) {
  return raw_bytes(PackedImage(image.view(), BitOrder::msb_first));
}

using TiffReading = OwnDirectory;
using TiffWriting = OwnDirectory;

TEST_F(TiffReading, reads_uncompressed_bits_in_both_orders_and_interpretations) {
  for (const Index width : {1, 8, 13, 200}) {
    const ByteImage image = noise_image(width, 5, 50, 1, 3);
    const ByteImage inverted = mapped(image, [](int pixel) { return pixel == 0 ? 255 : 0; });
    for (const BitOrder order : {BitOrder::msb_first, BitOrder::lsb_first}) {
      const int fill_order = order == BitOrder::msb_first ? 1 : 2;
      for (const int photometric : {PHOTOMETRIC_MINISWHITE, PHOTOMETRIC_MINISBLACK}) {
        const bool is_inverted = photometric == PHOTOMETRIC_MINISWHITE;
        const PackedImage bits((is_inverted ? inverted : image).view(), order, 0, 0xFF);
        put("a.tif", plain_tiff(static_cast<std::uint32_t>(width), 5, photometric, fill_order,
                                raw_bytes(bits)));
        EXPECT_EQ(rows_of("a.tif"), bits_of(image))
            << width << ", order " << fill_order << ", photometric " << photometric;
      }
    }
  }
}

TEST_F(TiffWriting, every_kind_is_read_and_written_again_without_a_changed_pixel) {
  constexpr std::uint16_t compressions[] = {
      COMPRESSION_NONE,    COMPRESSION_PACKBITS, COMPRESSION_LZW,       COMPRESSION_ADOBE_DEFLATE,
      COMPRESSION_DEFLATE, COMPRESSION_CCITTRLE, COMPRESSION_CCITTFAX3, COMPRESSION_CCITTFAX4};
  for (const Index width : {1, 64, 203}) {
    const ByteImage image = noise_image(width, 41, 70, 6, 3);
    for (int kind = 0; kind < 8 * 2 * 2 * 3; ++kind) {
      SCOPED_TRACE(kind);
      write_tiff(
          "in.tif", image.view(),
          {compressions[kind % 8],
           static_cast<std::uint16_t>(kind / 8 % 2 == 0 ? PHOTOMETRIC_MINISWHITE
                                                        : PHOTOMETRIC_MINISBLACK),
           static_cast<std::uint16_t>(kind / 16 % 2 == 0 ? FILLORDER_MSB2LSB : FILLORDER_LSB2MSB),
           std::array{1U, 7U, 100U}[static_cast<std::size_t>(kind / 32)]});
      EXPECT_EQ(rows_of("in.tif"), bits_of(image));
      write_rows("out.tif", format_of("in.tif"), width, 41, bits_of(image));
      EXPECT_EQ(rows_of("out.tif"), bits_of(image));
      EXPECT_TRUE(equal(read_grey("out.tif").view(), image.view()));
    }
  }
}

TEST_F(TiffWriting, keeps_compression_and_resolution_and_writes_bright_as_1) {
  for (const auto& [compression, expected] : {std::pair{COMPRESSION_NONE, COMPRESSION_NONE},
                                              {COMPRESSION_LZW, COMPRESSION_LZW},
                                              {COMPRESSION_CCITTFAX3, COMPRESSION_CCITTFAX4}}) {
    write_tiff("in.tif", ByteImage(40, 30).view(), {static_cast<std::uint16_t>(compression)});
    write_rows("out.tif", format_of("in.tif"), 40, 30, rows_of("in.tif"));
    EXPECT_EQ(tiff_tag("out.tif", TIFFTAG_COMPRESSION), expected);
    EXPECT_EQ(tiff_tag("out.tif", TIFFTAG_PHOTOMETRIC), PHOTOMETRIC_MINISBLACK);
    EXPECT_EQ(tiff_tag("out.tif", TIFFTAG_BITSPERSAMPLE), 1);
    EXPECT_EQ(format_of("out.tif").resolution, (std::array<float, 2>{204, 98}));
  }
}

TEST_F(TiffWriting, full_disk_is_reported) {
  const FileSizeLimit limit(1000);
  std::string rows(100 * 100, '\0');
  std::generate(rows.begin(), rows.end(),
                [i = 0U]() mutable { return static_cast<char>(splitmix64(1, ++i)); });
  EXPECT_EQ(rejection_of<FileError>([&] { write_rows("page.tif", {}, 800, 100, rows); }),
            "cannot write 'page.tif': File too large");
}

TEST_F(TiffReading, other_images_are_not_bilevel) {
  const ByteImage image(64, 32);
  write_tiff("tiles.tif", image.view(), {.tile = 16});
  write_tiff("bottom.tif", image.view(), {.orientation = ORIENTATION_BOTLEFT});
  write_grey("grey.tif", image.view());
  put("pbm.tif", "P4 2 2\n12");
  for (const char* name : {"tiles.tif", "bottom.tif", "grey.tif", "pbm.tif"}) {
    EXPECT_EQ(rows_of(name), "not packed") << name;
  }
}

/// What is wrong with a file of these bytes, which the decoder may not print.
std::string reason(const std::string& bytes) {
  std::ofstream("bad.tif", std::ios::binary) << bytes;
  testing::internal::CaptureStderr();
  const std::string error = rejection_of<FileError>([&] { static_cast<void>(rows_of("bad.tif")); });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  if (error.empty()) return "no rejection";
  EXPECT_TRUE(is_one_sentence(error)) << error;
  const std::string start = "cannot read 'bad.tif': ";
  return error.starts_with(start) ? error.substr(start.size()) : error;
}

TEST_F(TiffReading, sizes_are_checked_before_memory_is_taken) {
  const std::string rows(10, '\x55');
  const std::string whole = plain_tiff(16, 5, 1, 1, rows);
  EXPECT_EQ(reason(whole), "no rejection");
  EXPECT_EQ(reason(whole.substr(0, whole.size() - 1)), "the file is truncated");
  EXPECT_EQ(reason(plain_tiff(16, 6, 1, 1, rows)), "the file is truncated");
  EXPECT_EQ(reason(plain_tiff(4'000'000'000, 5, 1, 1, rows)), "the file is truncated");
  EXPECT_EQ(reason(plain_tiff(4'000'000'000, 1000, 1, 1, rows)), "it has more than 2^40 pixels");
  for (const int compression :
       {COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS, COMPRESSION_CCITTFAX4}) {
    EXPECT_EQ(reason(plain_tiff(1'000'000, 1000, 1, 1, rows, compression)),
              "its strips are too short for 1000000 x 1000 pixels");
  }
}

TEST_F(TiffReading, every_warning_of_the_decoder_is_a_failure) {
  write_tiff("a.tif", noise_image(200, 60, 70, 6, 3).view(), {COMPRESSION_CCITTFAX4});
  EXPECT_NE(reason(bytes_of("a.tif").replace(20, 3, 3, '\0')).find("at line"), std::string::npos);
}

TEST_F(TiffReading, damaged_files_give_pixels_or_one_line) {
  const ByteImage image = noise_image(200, 60, 70, 6, 3);
  for (const int compression :
       {COMPRESSION_NONE, COMPRESSION_PACKBITS, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE,
        COMPRESSION_CCITTFAX3, COMPRESSION_CCITTFAX4}) {
    write_tiff("a.tif", image.view(), {static_cast<std::uint16_t>(compression)});
    const std::string whole = bytes_of("a.tif");
    for (std::size_t i = 0; i < whole.size(); i += 1 + whole.size() / 150) {
      std::string bytes = whole;
      bytes[i] = static_cast<char>(bytes[i] ^ 0xA5);
      static_cast<void>(reason(bytes));
      if (i == 0) continue;  // an empty file is no TIFF file
      EXPECT_NE(reason(whole.substr(0, i)), "no rejection") << compression << ' ' << i;
    }
  }
}

TEST(BinarisePacked, says_what_binarise_says_of_the_same_image) {
  std::vector<ByteImage> images = {};
  for (const int percent : {0, 20, 50, 80, 100}) {
    for (const Index width : {1, 2, 9, 40}) {
      for (const Index height : {1, 2, 17}) {
        images.push_back(noise_image(width, height, percent, 1, static_cast<std::uint64_t>(width)));
      }
    }
  }
  for (const ByteImage& image : images) {
    const PackedImage bits(image.view(), BitOrder::msb_first);
    for (const Foreground foreground :
         {Foreground::automatic, Foreground::bright, Foreground::dark}) {
      const BinariseOptions options{.foreground = foreground};
      BrightPixels count;
      for (Index y = 0; y < image.height(); ++y) {
        add_rows(count, {bits.view().row(y), image.width(), 1, BitOrder::msb_first}, y,
                 image.height());
      }
      const BinaryImage packed = binarise_packed(count, options);
      const BinaryImage grey = binarise(copy_of(image.view()), options);
      EXPECT_EQ(packed.foreground, grey.foreground);
      EXPECT_EQ(packed.threshold, grey.threshold);
      EXPECT_EQ(packed.foreground_share, grey.foreground_share);
      EXPECT_NEAR(packed.separation, grey.only_level ? packed.separation : grey.separation, 1e-9);
      EXPECT_EQ(packed.only_level, grey.only_level);
      EXPECT_EQ(packed.was_binary, grey.was_binary);
    }
  }
}

TEST(PbmFormat, header_may_have_comments_and_any_spaces) {
  for (const std::string header :
       {"P4\n12 3\n", "P4 12 3 ", "P4\n# a\n# b 7\n12\t# c\n\n3\n", "P4#\n12 3\r"}) {
    const PackedFormat format = pbm_format({"image", header + "......"});
    EXPECT_EQ(format.width, 12) << header;
    EXPECT_EQ(format.height, 3) << header;
    EXPECT_EQ(format.header_bytes, header.size());
    EXPECT_EQ(format.file_bytes(), header.size() + 6);
  }
}

TEST(PackedForeground, counts_the_pixels_of_any_width) {
  for (const Index width : {1, 8, 63, 64, 65, 200, 1001}) {
    const ByteImage image = noise_image(width, 9, 60, 1, 4);
    Index expected = 0;
    for (Index y = 0; y < 9; ++y) {
      for (Index x = 0; x < width; ++x) expected += image.at(x, y) != 0 ? 1 : 0;
    }
    EXPECT_EQ(packed_foreground(PackedImage(image.view(), BitOrder::msb_first, 3).view()),
              expected);
  }
}

}  // namespace
}  // namespace thinbench
