#include "images/path_overlay.hpp"

#include <algorithm>

#include <opencv2/imgproc.hpp>

#include "images/image_file.hpp"
#include "images/mat_of.hpp"

namespace thinbench {
namespace {

cv::Mat drawn(const ConstImageView& grey, const std::vector<Pixel>& pixels, double width) {
  cv::Mat image;
  cv::cvtColor(mat_of(grey), image, cv::COLOR_GRAY2BGR);
  std::vector<cv::Point> line;
  for (const Pixel p : pixels) line.emplace_back(p.x, p.y);
  constexpr int widest = 32767;  // that OpenCV draws
  const int band = std::clamp(cvRound(width), 1, widest);
  cv::Mat light = image.clone();
  cv::polylines(light, line, false, {120, 190, 255}, band);
  cv::addWeighted(light, 0.6, image, 0.4, 0, image);
  cv::polylines(image, line, false, {0, 120, 230}, 1);
  cv::circle(image, line.front(), 4, {60, 160, 40}, cv::FILLED);
  cv::circle(image, line.back(), 4, {40, 40, 220}, cv::FILLED);
  return image;
}

}  // namespace

void write_path_overlay(const std::string& path, const ConstImageView& grey,
                        const std::vector<Pixel>& pixels, double width) {
  check_colour_extension(path);
  write_mat(path, [&] { return drawn(grey, pixels, width); });
}

}  // namespace thinbench
