#include "picture/overlay.hpp"

#include <opencv2/imgproc.hpp>

#include "picture/picture.hpp"
#include "picture/write_mat.hpp"

namespace thinbench {
namespace {

// Blue, green, red.
const cv::Scalar kObjectColour(0, 170, 0);
const cv::Scalar kHoleColour(40, 40, 255);

/// OpenCV only reads the pixels, but has no view of constant ones.
cv::Mat mat_of(const ConstByteView& view) {
  return {static_cast<int>(view.height), static_cast<int>(view.width), CV_8UC1,
          const_cast<std::uint8_t*>(view.data), static_cast<std::size_t>(view.stride)};
}

void draw_outlines(cv::Mat& picture, const ConstByteView& objects) {
  std::vector<std::vector<cv::Point>> contours;
  std::vector<cv::Vec4i> hierarchy;
  cv::findContours(mat_of(objects), contours, hierarchy, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const bool is_hole = hierarchy[i][3] >= 0;
    cv::polylines(picture, contours[i], true, is_hole ? kHoleColour : kObjectColour);
  }
}

void draw_centres(cv::Mat& picture, const std::vector<Region>& regions, const cv::Scalar& colour) {
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const cv::Point centre(cvRound(regions[i].centre_x()), cvRound(regions[i].centre_y()));
    constexpr int cross = 5;
    cv::drawMarker(picture, centre, colour, cv::MARKER_CROSS, cross);
    constexpr double font_scale = 0.35;
    cv::putText(picture, std::to_string(i + 1), centre + cv::Point(3, -3), cv::FONT_HERSHEY_SIMPLEX,
                font_scale, colour, 1, cv::LINE_AA);
  }
}

}  // namespace

void write_overlay(const std::string& path, const ConstByteView& grey, const ConstByteView& objects,
                   const FoundHoles& found) {
  check_colour_ending(path);
  cv::Mat picture;
  cv::cvtColor(mat_of(grey), picture, cv::COLOR_GRAY2BGR);
  draw_outlines(picture, objects);
  draw_centres(picture, found.objects, kObjectColour);
  draw_centres(picture, found.holes, kHoleColour);
  write_mat(path, picture);
}

}  // namespace thinbench
