#include <cstdlib>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "images/binarise.hpp"
#include "images/image_file.hpp"
#include "peers/mat_of.hpp"
#include "support/made_image.hpp"
#include "support/own_directory.hpp"
#include "support/rejection.hpp"
#include "support/tiff_bytes.hpp"

namespace thinbench {
namespace {

ByteImage ramp() {
  return image_by(67, 13, [](Index x, Index y) { return (x * 3 + y * 5) % 256; });
}

cv::Mat ramp_mat() {
  ByteImage image = ramp();
  return mat_of(image.view()).clone();
}

void write_by_opencv(const std::string& file, const cv::Mat& image = ramp_mat()) {
  ASSERT_TRUE(cv::imwrite(file, image, {cv::IMWRITE_JPEG_QUALITY, 100}));
}

void expect_ramp(const ByteImage& image, int tolerance) {
  const ByteImage expected = ramp();
  ASSERT_EQ(image.width(), expected.width());
  ASSERT_EQ(image.height(), expected.height());
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) {
      ASSERT_NEAR(image.at(x, y), expected.at(x, y), tolerance);
    }
  }
}

/// What reading the file says, and a failure where it writes to standard error on its own.
std::string error_of(const std::string& file) {
  testing::internal::CaptureStderr();
  const std::string text = rejection_of<FileError>([&] { static_cast<void>(read_grey(file)); });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  return text;
}

void expect_error(const std::string& file, const std::string& reason) {
  EXPECT_EQ(error_of(file), "cannot read '" + file + "': " + reason);
}

constexpr const char* kDamaged = "it is damaged or has no pixels";

/// Of an image read as far as possible.
GreyFile lenient(const std::string& file) {
  return read_grey_file(read_file(file), 0, {.lenient = true});
}

class ReadGrey : public OwnDirectory {
 protected:
  /// The error of a file of these bytes.
  static void expect_error_of(const std::string& name, const std::string& bytes,
                              const std::string& reason) {
    put(name, bytes);
    expect_error(name, reason);
  }
  /// Grey levels of a file of one row.
  static std::vector<int> levels_of(const std::string& bytes) {
    put("a.pgm", bytes);
    const ByteImage image = read_grey("a.pgm");
    return {image.view().data, image.view().data + image.width()};
  }
};

TEST_F(ReadGrey, keeps_every_pixel_in_8_and_16_bits_and_jpeg_nearly) {
  cv::Mat deep;
  ramp_mat().convertTo(deep, CV_16UC1, 257);
  for (const std::string name : {"a.png", "a.pgm", "a.bmp", "a.tif", "a.jpg"}) {
    write_by_opencv(name);
    expect_ramp(read_grey(name), name == "a.jpg" ? 3 : 0);
    if (name == "a.bmp" || name == "a.jpg") continue;
    write_by_opencv(name, deep);
    expect_ramp(read_grey(name), 0);
  }
}

TEST_F(ReadGrey, transparency_is_left_out) {
  write_by_opencv("a.png", cv::Mat(2, 3, CV_8UC4, cv::Scalar(77, 77, 77, 0)));
  EXPECT_EQ(read_grey("a.png").at(2, 1), 77);
}

TEST_F(ReadGrey, colours_become_the_same_grey_in_every_format) {
  constexpr int width = 256, height = 16;
  std::string samples(std::size_t{3} * width * height, ' ');  // red, green, blue
  std::mt19937 random(1);
  for (char& sample : samples) sample = static_cast<char>(random());
  ByteImage expected(width, height);
  const auto* const data = reinterpret_cast<const std::uint8_t*>(samples.data());
  select_channel({data, width, height, 3 * width}, expected.view(), Channel::grey);
  put("a.ppm", "P6 256 16 255\n" + samples);
  put("a.pam", "P7\nWIDTH 256\nHEIGHT 16\nDEPTH 3\nMAXVAL 255\nTUPLTYPE RGB\nENDHDR\n" + samples);
  const cv::Mat colours = cv::imread("a.ppm");
  for (const char* name : {"a.png", "a.bmp", "a.tif"}) write_by_opencv(name, colours);
  for (const char* name : {"a.png", "a.ppm", "a.pam", "a.bmp", "a.tif"}) {
    EXPECT_TRUE(equal(read_grey(name).view(), expected.view())) << name;
  }
  ASSERT_TRUE(cv::imwritemulti("pages.tif", std::vector{ramp_mat(), colours}));
  EXPECT_TRUE(equal(read_grey("pages.tif", 1).view(), expected.view()));
}

TEST_F(ReadGrey, what_is_no_image_is_rejected_with_the_reason) {
  expect_error("absent.png", "there is no such file");
  expect_error(".", "it is a directory");
  expect_error("/dev/null", "it is not a regular file");
  expect_error_of("a.png", "", "the file is empty");
  expect_error_of("a.png", "this is text", "it is not an image of a known format");
}

TEST_F(ReadGrey, image_without_pixels_is_rejected) {
  for (const char* header :
       {"P5 0 7 255\n", "P2\n# a comment\n7 0\n255\n", "P2\n1544444444444444444 -444\n255\n"}) {
    expect_error_of("a.pgm", header, kDamaged);
  }
  for (const auto& [name, at] :
       {std::pair("a.png", 16U), {"a.png", 20U}, {"a.bmp", 18U}, {"a.bmp", 22U}}) {
    write_by_opencv(name);
    put(name, bytes_of(name).replace(at, 4, 4, '\0'));
    EXPECT_NE(error_of(name).find("damaged"), std::string::npos) << error_of(name);
  }
}

TEST_F(ReadGrey, truncated_files_are_rejected_without_a_word_from_the_decoder) {
  cv::Mat large;
  cv::repeat(ramp_mat(), 20, 5, large);
  for (const std::string name : {"a.png", "a.tif", "a.jpg", "a.pgm", "a.bmp"}) {
    write_by_opencv(name, large);
    const std::string cut = bytes_of(name).substr(0, bytes_of(name).size() / 2);
    const std::string too_few =
        "it has " + std::to_string(cut.size()) + " bytes, too few for 335 x 260 pixels";
    const bool is_raw = name == "a.pgm" || name == "a.bmp";
    expect_error_of(name, cut,
                    is_raw            ? too_few
                    : name == "a.png" ? "it is damaged: the file is truncated"
                    : name == "a.tif" ? "it is damaged: Can not read TIFF directory count"
                                      : "the file is truncated");
  }
}

TEST_F(ReadGrey, damaged_png_is_rejected) {
  write_by_opencv("a.png");
  std::string bytes = bytes_of("a.png");
  bytes[bytes.size() / 2] = static_cast<char>(~bytes[bytes.size() / 2]);
  expect_error_of("a.png", bytes, "it is damaged: IDAT: invalid bit length repeat");
}

TEST_F(ReadGrey, corrupt_jpeg_is_rejected_or_leniently_read_with_what_the_decoder_says) {
  const auto tells_of_extraneous_bytes = [](const std::string& text) {
    return text.find("its decoder says: Corrupt JPEG data: ") != std::string::npos &&
           text.ends_with(" extraneous bytes before marker 0xd9");
  };
  write_by_opencv("a.jpg");
  const std::string sound = bytes_of("a.jpg");
  put("corrupt.jpg", std::string(sound).insert(sound.size() - 2, 64, '\x12'));
  put("cut.jpg", sound.substr(0, sound.size() - 100));
  EXPECT_TRUE(tells_of_extraneous_bytes(error_of("corrupt.jpg"))) << error_of("corrupt.jpg");
  const GreyFile corrupt = lenient("corrupt.jpg");
  expect_ramp(corrupt.grey.bytes, 10);
  EXPECT_TRUE(tells_of_extraneous_bytes(corrupt.warning)) << corrupt.warning;
  EXPECT_EQ(lenient("a.jpg").warning, "");
  EXPECT_EQ(lenient("cut.jpg").grey.width, 67);
  EXPECT_EQ(lenient("cut.jpg").warning, "the file is truncated");
}

TEST_F(ReadGrey, maximum_of_a_pgm_up_to_255_is_white_and_above_samples_are_as_they_are) {
  using Levels = std::vector<int>;
  const Levels expected = {0, 127, 255};
  EXPECT_EQ(levels_of(std::string("P5 2 1 1\n\0\1", 11)), (Levels{0, 255}));
  EXPECT_EQ(levels_of(std::string("P5 3 1 # a comment\n100\n\0\62\144", 26)), expected);
  EXPECT_EQ(levels_of("P2 3 1 100\n0 50 100\n"), expected);
  const Levels quarters = {0, 124, 250};  // in 8 bits
  EXPECT_EQ(levels_of(std::string("P5 3 1 1000\n\0\0\1\363\3\350", 18)), quarters);
  EXPECT_EQ(levels_of("P2 3 1 1000\n0 499 1000\n"), quarters);
  EXPECT_EQ(levels_of(std::string("P6 2 1 1\n\0\0\0\1\1\1", 15)), (Levels{0, 255}));
  EXPECT_EQ(levels_of(std::string("P5 3 1 255\n\0\177\377", 14)), expected);
  EXPECT_EQ(levels_of(std::string("P5 3 1 65535\n\0\0\177\377\377\377", 19)), expected);
}

TEST_F(ReadGrey, pam_has_any_maximum_and_opacity) {
  const auto header = [](int depth, int maximum) {
    return "P7\nWIDTH 1\nHEIGHT 1\nDEPTH " + std::to_string(depth) + "\nMAXVAL " +
           std::to_string(maximum) + "\nENDHDR\n";
  };
  EXPECT_EQ(levels_of(header(1, 255) + "\377"), std::vector<int>{255});
  EXPECT_EQ(levels_of(header(1, 1) + "\1"), std::vector<int>{255});
  EXPECT_EQ(levels_of(header(2, 255) + "\77\1"), std::vector<int>{63});
  EXPECT_EQ(levels_of(header(4, 255) + "\77\77\77\1"), std::vector<int>{63});
  expect_error_of("a.pam", header(5, 255) + "12345", kDamaged);
}

TEST_F(ReadGrey, last_number_of_a_text_needs_no_newline) {
  EXPECT_EQ(levels_of("P2 3 1 255\n0 17 255"), (std::vector<int>{0, 17, 255}));
  EXPECT_EQ(levels_of("P3 1 1 255\n9 9 9"), std::vector<int>{9});
}

TEST_F(ReadGrey, tiff_with_samples_that_are_not_read_is_not_called_damaged) {
  const std::string known =
      "; known are integers of 1 to 16 and of 32 bits, and real numbers of 32 and 64";
  constexpr std::size_t kBitsPerSample = 42;  // where plain_tiff() has this number
  std::string tiff =
      plain_tiff(1, 1, PHOTOMETRIC_MINISBLACK, FILLORDER_MSB2LSB, "\1\2\3\4\5\6\7\10");
  for (const int bits : {24, 64}) {
    tiff[kBitsPerSample] = static_cast<char>(bits);
    expect_error_of("a.tif", tiff,
                    "its samples are integers of " + std::to_string(bits) + " bits" + known);
  }
  constexpr std::size_t kCompression = 54;
  tiff[kBitsPerSample] = 8;
  tiff.replace(kCompression, 2, "\x98\x87");  // 34712
  expect_error_of("a.tif", tiff, "its compression 34712, JPEG 2000, is not supported");
}

TEST_F(ReadGrey, more_pixels_than_2_to_the_31_are_rejected_by_the_header) {
  expect_error_of("a.pgm", "P2 1544444444444444444 4 255\n0 1", "it has more than 2^31 pixels");
  expect_error_of("a.pgm", "P5 70000 70000 255\n", "it has more than 2^31 pixels");
}

}  // namespace
}  // namespace thinbench
