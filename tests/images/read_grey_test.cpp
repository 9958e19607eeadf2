#include <cstdlib>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <tiffio.h>

#include "images/captured_stderr.hpp"
#include "images/image_file.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

constexpr int kWidth = 67;
constexpr int kHeight = 13;

int grey_at(int x, int y) {
  return (x * 3 + y * 5) % 256;
}

cv::Mat ramp() {
  cv::Mat mat(kHeight, kWidth, CV_8UC1);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      mat.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(grey_at(x, y));
    }
  }
  return mat;
}

void expect_ramp(const ByteImage& image, int tolerance) {
  ASSERT_EQ(image.width(), kWidth);
  ASSERT_EQ(image.height(), kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) ASSERT_NEAR(image.at(x, y), grey_at(x, y), tolerance);
  }
}

/// What reading the file says, and a failure where it writes to standard error on its own.
std::string error_of(const std::string& file) {
  const CapturedStderr captured;
  std::string text = "no error";
  try {
    static_cast<void>(read_grey(file));
  } catch (const FileError& error) {
    text = error.what();
  }
  EXPECT_EQ(captured.text(), "");
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  return text;
}

void expect_error(const std::string& file, const std::string& reason) {
  EXPECT_EQ(error_of(file), "cannot read '" + file + "': " + reason);
}

constexpr const char* kDamaged = "it is damaged or has no pixels";

class GreyFile : public testing::TestWithParam<const char*> {};

TEST_P(GreyFile, keeps_every_pixel) {
  const TemporaryDirectory directory;
  const std::string file = directory.file(std::string("a.") + GetParam());
  ASSERT_TRUE(cv::imwrite(file, ramp()));
  expect_ramp(read_grey(file), 0);
}

INSTANTIATE_TEST_SUITE_P(Formats, GreyFile, testing::Values("png", "pgm", "bmp", "tif"));

TEST(ReadGrey, jpeg_comes_out_nearly_as_it_was) {
  const TemporaryDirectory directory;
  ASSERT_TRUE(cv::imwrite(directory.file("a.jpg"), ramp(), {cv::IMWRITE_JPEG_QUALITY, 100}));
  expect_ramp(read_grey(directory.file("a.jpg")), 3);
}

TEST(ReadGrey, sixteen_bits_become_eight) {
  const TemporaryDirectory directory;
  cv::Mat deep;
  ramp().convertTo(deep, CV_16UC1, 257);
  for (const char* ending : {"png", "pgm", "tif"}) {
    const std::string file = directory.file(std::string("deep.") + ending);
    ASSERT_TRUE(cv::imwrite(file, deep));
    expect_ramp(read_grey(file), 0);
  }
}

TEST(ReadGrey, colours_become_grey_and_transparency_is_left_out) {
  const TemporaryDirectory directory;
  const cv::Mat transparent(2, 3, CV_8UC4, cv::Scalar(77, 77, 77, 0));
  ASSERT_TRUE(cv::imwrite(directory.file("a.png"), transparent));
  EXPECT_EQ(read_grey(directory.file("a.png")).at(2, 1), 77);
}

TEST(ReadGrey, missing_file_is_named) {
  const TemporaryDirectory directory;
  expect_error(directory.file("absent.png"), "there is no such file");
}

TEST(ReadGrey, directory_is_no_image) {
  const TemporaryDirectory directory;
  expect_error(directory.path().string(), "it is a directory");
}

TEST(ReadGrey, device_is_no_image) {
  expect_error("/dev/null", "it is not a regular file");
}

TEST(ReadGrey, protected_file_is_rejected) {
  const TemporaryDirectory directory;
  const std::string file = directory.with("a.pgm", "P5 1 1 255\nx");
  std::filesystem::permissions(file, std::filesystem::perms::none);
  if (std::ifstream(file).good()) GTEST_SKIP() << "this user may read everything";
  expect_error(file, "Permission denied");
}

TEST(ReadGrey, empty_file_is_rejected) {
  const TemporaryDirectory directory;
  expect_error(directory.with("a.png", ""), "the file is empty");
}

TEST(ReadGrey, text_is_no_image) {
  const TemporaryDirectory directory;
  expect_error(directory.with("a.png", "this is text"), "it is not an image of a known format");
}

TEST(ReadGrey, image_without_pixels_is_rejected) {
  const TemporaryDirectory directory;
  for (const char* header :
       {"P5 0 7 255\n", "P2\n# a comment\n7 0\n255\n", "P2\n1544444444444444444 -444\n255\n"}) {
    expect_error(directory.with("a.pgm", header), "it is damaged or has no pixels");
  }
  ASSERT_TRUE(cv::imwrite(directory.file("a.png"), ramp()));
  ASSERT_TRUE(cv::imwrite(directory.file("a.bmp"), ramp()));
  for (const auto& [name, at] :
       {std::pair("a.png", 16U), {"a.png", 20U}, {"a.bmp", 18U}, {"a.bmp", 22U}}) {
    const std::string bytes = bytes_of(directory.file(name)).replace(at, 4, 4, '\0');
    expect_error(directory.with(std::string("b.") + name, bytes), "it is damaged or has no pixels");
  }
}

class CutFile : public testing::TestWithParam<const char*> {};

TEST_P(CutFile, is_rejected_without_a_word_from_the_decoder) {
  const TemporaryDirectory directory;
  const std::string whole = directory.file(std::string("a.") + GetParam());
  cv::Mat large;
  cv::repeat(ramp(), 20, 5, large);
  ASSERT_TRUE(cv::imwrite(whole, large));
  const std::string bytes = bytes_of(whole);
  const std::string cut =
      directory.with(std::string("cut.") + GetParam(), bytes.substr(0, bytes.size() / 2));
  const std::string kind = GetParam();
  const std::string too_few =
      "it has " + std::to_string(bytes.size() / 2) + " bytes, too few for 335 x 260 pixels";
  expect_error(cut, kind == "jpg"                    ? "the file is truncated"
                    : kind == "pgm" || kind == "bmp" ? too_few
                                                     : kDamaged);
}

INSTANTIATE_TEST_SUITE_P(Formats, CutFile, testing::Values("png", "pgm", "bmp", "tif", "jpg"));

TEST(ReadGrey, damaged_png_is_rejected) {
  const TemporaryDirectory directory;
  ASSERT_TRUE(cv::imwrite(directory.file("a.png"), ramp()));
  std::string bytes = bytes_of(directory.file("a.png"));
  bytes[bytes.size() / 2] = static_cast<char>(~bytes[bytes.size() / 2]);
  expect_error(directory.with("b.png", bytes), kDamaged);
}

/// A JPEG file, and one with 64 bytes between the data and the end marker.
std::pair<std::string, std::string> sound_and_corrupt_jpeg(const TemporaryDirectory& directory) {
  const std::string file = directory.file("a.jpg");
  EXPECT_TRUE(cv::imwrite(file, ramp(), {cv::IMWRITE_JPEG_QUALITY, 100}));
  std::string bytes = bytes_of(file);
  return {file, directory.with("b.jpg", bytes.insert(bytes.size() - 2, 64, '\x12'))};
}

bool tells_of_extraneous_bytes(const std::string& text) {
  return text.find("its decoder says: Corrupt JPEG data: ") != std::string::npos &&
         text.ends_with(" extraneous bytes before marker 0xd9");
}

TEST(ReadGrey, corrupt_jpeg_is_rejected_with_what_the_decoder_says) {
  const TemporaryDirectory directory;
  const auto [sound, corrupt] = sound_and_corrupt_jpeg(directory);
  expect_ramp(read_grey(sound), 10);
  EXPECT_TRUE(tells_of_extraneous_bytes(error_of(corrupt))) << error_of(corrupt);
}

TEST(ReadGrey, leniently_a_corrupt_jpeg_is_read_with_a_warning) {
  const TemporaryDirectory directory;
  const auto [sound, corrupt] = sound_and_corrupt_jpeg(directory);
  std::string warning;
  expect_ramp(read_grey(corrupt, &warning), 10);
  EXPECT_TRUE(tells_of_extraneous_bytes(warning)) << warning;
  expect_ramp(read_grey(sound, &warning), 10);
  EXPECT_EQ(warning, "");
  const std::string bytes = bytes_of(sound);
  const std::string cut = directory.with("cut.jpg", bytes.substr(0, bytes.size() - 100));
  EXPECT_EQ(read_grey(cut, &warning).width(), kWidth);
  EXPECT_EQ(warning, "the file is truncated");
}

/// Grey levels of a file of one row.
std::vector<int> levels_of(const std::string& bytes) {
  const TemporaryDirectory directory;
  const ByteImage image = read_grey(directory.with("a.pgm", bytes));
  return {image.view().data, image.view().data + image.width()};
}

TEST(ReadGrey, maximum_of_a_pgm_is_white_whatever_it_is) {
  using Levels = std::vector<int>;
  const Levels expected = {0, 127, 255};
  EXPECT_EQ(levels_of(std::string("P5 2 1 1\n\0\1", 11)), (Levels{0, 255}));
  EXPECT_EQ(levels_of(std::string("P5 3 1 # a comment\n100\n\0\62\144", 26)), expected);
  EXPECT_EQ(levels_of("P2 3 1 100\n0 50 100\n"), expected);
  EXPECT_EQ(levels_of(std::string("P5 3 1 1000\n\0\0\1\363\3\350", 18)), expected);
  EXPECT_EQ(levels_of("P2 3 1 1000\n0 499 1000\n"), expected);
  EXPECT_EQ(levels_of(std::string("P6 2 1 1\n\0\0\0\1\1\1", 15)), (Levels{0, 255}));
  EXPECT_EQ(levels_of(std::string("P5 3 1 255\n\0\177\377", 14)), expected);
  EXPECT_EQ(levels_of(std::string("P5 3 1 65535\n\0\0\177\377\377\377", 19)), expected);
}

TEST(ReadGrey, pam_of_another_maximum_is_rejected) {
  const TemporaryDirectory directory;
  const std::string header = "P7\nWIDTH 1\nHEIGHT 1\nDEPTH 1\nTUPLTYPE GRAYSCALE\nMAXVAL ";
  EXPECT_EQ(levels_of(header + "255\nENDHDR\n\377"), std::vector<int>{255});
  expect_error(directory.with("a.pam", header + "1\nENDHDR\n\1"),
               "its maximum is 1; known for PAM files are 255 and 65535");
}

TEST(ReadGrey, last_number_of_a_text_needs_no_newline) {
  EXPECT_EQ(levels_of("P2 3 1 255\n0 17 255"), (std::vector<int>{0, 17, 255}));
  EXPECT_EQ(levels_of("P3 1 1 255\n9 9 9"), std::vector<int>{9});
}

/// A TIFF image of one pixel, black, with samples of this kind.
void write_tiff_pixel(const std::string& path, int bits, int format) {
  TIFF* const tiff = TIFFOpen(path.c_str(), "w");
  ASSERT_NE(tiff, nullptr);
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 1);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 1);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, format);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  std::string pixel(8, '\0');
  ASSERT_EQ(TIFFWriteScanline(tiff, pixel.data(), 0), 1);
  TIFFClose(tiff);
}

TEST(ReadGrey, tiff_with_other_samples_is_not_called_damaged) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("a.tif");
  const std::string known = "; known are integers of 1, 8 and 16 bits";
  for (const int bits : {2, 4, 32}) {
    write_tiff_pixel(file, bits, SAMPLEFORMAT_UINT);
    expect_error(file, "its samples have " + std::to_string(bits) + " bits" + known);
  }
  write_tiff_pixel(file, 32, SAMPLEFORMAT_IEEEFP);
  expect_error(file, "its samples have 32 bits and are no unsigned integers" + known);
}

TEST(ReadGrey, size_beyond_the_decoder_is_rejected_by_its_header) {
  if (std::getenv("OPENCV_IO_MAX_IMAGE_PIXELS") != nullptr) GTEST_SKIP() << "the limit is changed";
  const TemporaryDirectory directory;
  expect_error(directory.with("a.pgm", "P5 70000 70000 255\n"),
               "it has more than 2^30 pixels; set OPENCV_IO_MAX_IMAGE_PIXELS=2147483648 in the "
               "environment to read up to 2^31");
}

TEST(ReadGrey, width_beyond_the_decoder_is_rejected) {
  const TemporaryDirectory directory;
  expect_error(directory.with("a.pgm", "P5 2000000 1 255\n"),
               "it is wider or higher than 2^20 pixels");
}

TEST(ReadGrey, sides_whose_bytes_overflow_are_rejected) {
  const TemporaryDirectory directory;
  expect_error(directory.with("a.pgm", "P2 1544444444444444444 4 255\n0 1"),
               "it is damaged or has no pixels");
}

}  // namespace
}  // namespace thinbench
