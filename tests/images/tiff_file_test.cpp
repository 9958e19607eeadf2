// TIFF images of 1 bit per pixel, read and written by rows.
#include "images/tiff_file.hpp"

#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "images/binarise.hpp"
#include "support/file_size_limit.hpp"
#include "support/packed_image.hpp"
#include "support/rejection.hpp"
#include "support/temporary_directory.hpp"
#include "support/tiff_bytes.hpp"

namespace thinbench {
namespace {

/// All rows, in parts of three at most. Takes no memory for rows that cannot be read.
std::string rows_of(const std::string& path) {
  TiffReader reader(path);
  const TiffFormat& format = reader.format();
  std::string bytes;
  for (Index y = 0; y < format.height; y += 3) {
    const Index rows = std::min<Index>(3, format.height - y);
    std::vector<std::uint8_t> part(static_cast<std::size_t>(rows * format.row_bytes()), 0x55);
    reader.read(rows, part.data());
    bytes.append(part.begin(), part.end());
  }
  return bytes;
}

TEST(TiffReader, reads_uncompressed_bits_in_both_orders_and_interpretations) {
  const TemporaryDirectory directory;
  for (const Index width : {1, 8, 13, 200}) {
    const ByteImage image = noise_image(width, 5, 50, 1, 3);
    ByteImage inverted(width, 5);
    for (Index i = 0; i < width * 5; ++i) {
      inverted.at(i % width, i / width) = image.at(i % width, i / width) == 0 ? 255 : 0;
    }
    for (const BitOrder order : {BitOrder::msb_first, BitOrder::lsb_first}) {
      const int fill_order = order == BitOrder::msb_first ? 1 : 2;
      for (const int photometric : {PHOTOMETRIC_MINISWHITE, PHOTOMETRIC_MINISBLACK}) {
        const bool is_inverted = photometric == PHOTOMETRIC_MINISWHITE;
        const PackedImage bits((is_inverted ? inverted : image).view(), order, 0, 0xFF);
        const std::string file =
            directory.with("a.tif", plain_tiff(static_cast<std::uint32_t>(width), 5, photometric,
                                               fill_order, raw_bytes(bits)));
        ASSERT_TRUE(is_bilevel_tiff(file));
        EXPECT_EQ(rows_of(file), raw_bytes(PackedImage(image.view(), BitOrder::msb_first)))
            << width << ", order " << fill_order << ", photometric " << photometric;
      }
    }
  }
}

using Kind = std::tuple<int, int, int, int>;

class TiffKinds : public testing::TestWithParam<Kind> {
 protected:
  [[nodiscard]] static TiffKind kind() {
    const auto [compression, photometric, fill_order, rows] = GetParam();
    return {static_cast<std::uint16_t>(compression), static_cast<std::uint16_t>(photometric),
            static_cast<std::uint16_t>(fill_order), static_cast<std::uint32_t>(rows)};
  }
};

TEST_P(TiffKinds, are_read_and_written_again_without_a_changed_pixel) {
  const TemporaryDirectory directory;
  for (const Index width : {1, 64, 203}) {
    const ByteImage image = noise_image(width, 41, 70, 6, 3);
    const std::string in = directory.file("in.tif"), out = directory.file("out.tif");
    write_tiff(in, image.view(), kind());
    const std::string rows = rows_of(in);
    EXPECT_EQ(rows, raw_bytes(PackedImage(image.view(), BitOrder::msb_first)));
    TiffWriter writer(out, out, TiffReader(in).format());
    writer.write(20, reinterpret_cast<const std::uint8_t*>(rows.data()));
    writer.write(21,
                 reinterpret_cast<const std::uint8_t*>(rows.data()) + 20 * packed_row_bytes(width));
    writer.finish();
    EXPECT_EQ(rows_of(out), rows);
    EXPECT_TRUE(equal(read_grey(out).view(), image.view()));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, TiffKinds,
    testing::Combine(testing::Values(COMPRESSION_NONE, COMPRESSION_PACKBITS, COMPRESSION_LZW,
                                     COMPRESSION_ADOBE_DEFLATE, COMPRESSION_DEFLATE,
                                     COMPRESSION_CCITTRLE, COMPRESSION_CCITTFAX3,
                                     COMPRESSION_CCITTFAX4),
                     testing::Values(PHOTOMETRIC_MINISWHITE, PHOTOMETRIC_MINISBLACK),
                     testing::Values(FILLORDER_MSB2LSB, FILLORDER_LSB2MSB),
                     testing::Values(1, 7, 100)));

TEST(TiffWriter, keeps_compression_and_resolution_and_writes_bright_as_1) {
  const TemporaryDirectory directory;
  const std::string in = directory.file("in.tif"), out = directory.file("out.tif");
  for (const auto& [compression, expected] : {std::pair{COMPRESSION_NONE, COMPRESSION_NONE},
                                              {COMPRESSION_LZW, COMPRESSION_LZW},
                                              {COMPRESSION_CCITTFAX3, COMPRESSION_CCITTFAX4}}) {
    write_tiff(in, ByteImage(40, 30).view(), {static_cast<std::uint16_t>(compression)});
    const std::string rows = rows_of(in);
    const TiffFormat format = TiffReader(in).format();
    TiffWriter writer(out, out, format);
    writer.write(30, reinterpret_cast<const std::uint8_t*>(rows.data()));
    writer.finish();
    EXPECT_EQ(tiff_tag(out, TIFFTAG_COMPRESSION), expected);
    EXPECT_EQ(tiff_tag(out, TIFFTAG_PHOTOMETRIC), PHOTOMETRIC_MINISBLACK);
    EXPECT_EQ(tiff_tag(out, TIFFTAG_BITSPERSAMPLE), 1);
    EXPECT_EQ(TiffReader(out).format().resolution, (std::array<float, 2>{204, 98}));
  }
}

TEST(TiffWriter, full_disk_is_reported) {
  const TemporaryDirectory directory;
  const FileSizeLimit limit(1000);
  EXPECT_EQ(rejection_of<FileError>([&] {
              TiffWriter writer(directory.file("a.tif"), "page.tif", {.width = 800, .height = 100});
              const std::vector<std::uint8_t> rows(100 * 100);
              writer.write(100, rows.data());
              writer.finish();
            }),
            "cannot write 'page.tif': File too large");
}

TEST(IsBilevelTiff, other_images_are_not) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("a.tif");
  const ByteImage image(64, 32);
  write_tiff(file, image.view(), {.tile = 16});
  EXPECT_FALSE(is_bilevel_tiff(file));
  write_tiff(file, image.view(), {.orientation = ORIENTATION_BOTLEFT});
  EXPECT_FALSE(is_bilevel_tiff(file));
  write_grey(file, image.view());  // 8 bits
  EXPECT_FALSE(is_bilevel_tiff(file));
  EXPECT_EQ(rejection_of<FileError>([&] { TiffReader reader(file); }),
            "cannot read '" + file + "': it is not a TIFF image of 1 bit per pixel in strips");
  for (const std::string& name : {directory.file("absent"), directory.path().string(),
                                  directory.with("b.tif", "P4 2 2\n12")}) {
    EXPECT_FALSE(is_bilevel_tiff(name)) << name;
  }
}

/// What is wrong with a file of these bytes.
std::string reason(const TemporaryDirectory& directory, const std::string& bytes) {
  const std::string file = directory.with("bad.tif", bytes);
  const std::string error = rejection_of<FileError>([&] { rows_of(file); });
  if (error.empty()) return "no rejection";
  EXPECT_TRUE(is_one_sentence(error)) << error;
  const std::string start = "cannot read '" + file + "': ";
  return error.starts_with(start) ? error.substr(start.size()) : error;
}

TEST(TiffReader, sizes_are_checked_before_memory_is_taken) {
  const TemporaryDirectory directory;
  const std::string rows(10, '\x55');
  EXPECT_EQ(reason(directory, plain_tiff(16, 5, 1, 1, rows)), "no rejection");
  EXPECT_EQ(reason(directory, plain_tiff(16, 6, 1, 1, rows)), "the file is truncated");
  EXPECT_EQ(reason(directory, plain_tiff(4'000'000'000, 5, 1, 1, rows)), "the file is truncated");
  EXPECT_EQ(reason(directory, plain_tiff(4'000'000'000, 1000, 1, 1, rows)),
            "its size is 4000000000 x 1000; expected 1 to 2^40 pixels");
  for (const int compression :
       {COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS, COMPRESSION_CCITTFAX4}) {
    EXPECT_EQ(reason(directory, plain_tiff(1'000'000, 1000, 1, 1, rows, compression)),
              "its strips are too short for 1000000 x 1000 pixels");
  }
  const std::string whole = plain_tiff(16, 5, 1, 1, rows);
  EXPECT_EQ(reason(directory, whole.substr(0, whole.size() - 1)), "the file is truncated");
  EXPECT_EQ(reason(directory, ""), "the file is empty");
}

TEST(TiffReader, every_warning_of_the_decoder_is_a_failure) {
  const TemporaryDirectory directory;
  const ByteImage image = noise_image(200, 60, 70, 6, 3);
  const std::string file = directory.file("a.tif");
  write_tiff(file, image.view(), {COMPRESSION_CCITTFAX4});
  std::string bytes = bytes_of(file);
  bytes[20] = '\0';
  bytes[21] = '\0';
  bytes[22] = '\0';
  testing::internal::CaptureStderr();
  EXPECT_NE(reason(directory, bytes).find("at line"), std::string::npos);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(TiffReader, damaged_files_give_pixels_or_one_line) {
  const TemporaryDirectory directory;
  const ByteImage image = noise_image(200, 60, 70, 6, 3);
  const std::string file = directory.file("a.tif");
  testing::internal::CaptureStderr();
  for (const int compression :
       {COMPRESSION_NONE, COMPRESSION_PACKBITS, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE,
        COMPRESSION_CCITTFAX3, COMPRESSION_CCITTFAX4}) {
    write_tiff(file, image.view(), {static_cast<std::uint16_t>(compression)});
    const std::string whole = bytes_of(file);
    for (std::size_t i = 0; i < whole.size(); i += 1 + whole.size() / 150) {
      std::string bytes = whole;
      bytes[i] = static_cast<char>(bytes[i] ^ 0xA5);
      static_cast<void>(reason(directory, bytes));
      EXPECT_NE(reason(directory, whole.substr(0, i)), "no rejection") << compression << ' ' << i;
    }
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
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

}  // namespace
}  // namespace thinbench
