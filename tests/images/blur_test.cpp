#include "images/blur.hpp"

#include <algorithm>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "harness/splitmix64.hpp"

namespace thinbench {
namespace {

Pixels noise(Index width, Index height, SampleKind kind) {
  Pixels image = make_pixels(width, height, 1, kind);
  std::uint64_t index = 0;
  std::generate_n(image.bytes.get(), height * image.row_bytes(),
                  [&] { return static_cast<std::uint8_t>(splitmix64(5, ++index)); });
  return image;
}

cv::Mat blurred_by_opencv(const Pixels& image, double sigma) {
  const int type = image.kind == SampleKind::u8 ? CV_8UC1 : CV_16UC1;
  const cv::Mat source(static_cast<int>(image.height), static_cast<int>(image.width), type,
                       image.bytes.get());
  cv::Mat result;
  cv::GaussianBlur(source, result, {}, sigma, sigma, cv::BORDER_REPLICATE);
  return result;
}

TEST(Blur, is_that_of_opencv) {
  for (const SampleKind kind : {SampleKind::u8, SampleKind::u16}) {
    for (const double sigma : {0.3, 1.0, 2.5, 9.0}) {
      for (const Index width : {1, 7, 100}) {
        const Pixels image = noise(width, 23, kind);
        const cv::Mat expected = blurred_by_opencv(image, sigma);
        blur(image, sigma);
        const cv::Mat blurred(expected.rows, expected.cols, expected.type(), image.bytes.get());
        EXPECT_LE(cv::norm(blurred, expected, cv::NORM_INF), kind == SampleKind::u8 ? 0 : 1)
            << sigma << ' ' << width;
      }
    }
  }
}

}  // namespace
}  // namespace thinbench
