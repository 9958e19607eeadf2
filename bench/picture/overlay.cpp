#include "picture/overlay.hpp"

#include <algorithm>

#include <opencv2/imgproc.hpp>

#include "picture/mat_of.hpp"
#include "picture/picture.hpp"
#include "picture/write_mat.hpp"

namespace thinbench {
namespace {

// Blue, green, red.
const cv::Scalar kObjectColour(0, 170, 0);
const cv::Scalar kHoleColour(40, 40, 255);

void draw_outlines(cv::Mat& picture, const ConstByteView& objects) {
  std::vector<std::vector<cv::Point>> contours;
  std::vector<cv::Vec4i> hierarchy;
  cv::findContours(mat_of(objects), contours, hierarchy, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const bool is_hole = hierarchy[i][3] >= 0;
    cv::polylines(picture, contours[i], true, is_hole ? kHoleColour : kObjectColour);
  }
}

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kFontScale = 0.35;

cv::Rect box_of(const Region& region) {
  return {region.left, region.top, region.right - region.left + 1, region.bottom - region.top + 1};
}

cv::Point centre_of(const Region& region) {
  return {cvRound(region.centre_x()), cvRound(region.centre_y())};
}

/// The number of a region; `place` is the lower left corner of its text.
struct Label {
  std::string text;
  cv::Size size;

  explicit Label(std::size_t id)
      : text(std::to_string(id)), size(cv::getTextSize(text, kFont, kFontScale, 1, nullptr)) {}

  [[nodiscard]] bool fits(const cv::Rect& box) const {
    return size.width < box.width && size.height < box.height;
  }
  /// Moved so far that all of it lies in the picture.
  void draw(cv::Mat& picture, cv::Point place, const cv::Scalar& colour) const {
    place.x = std::clamp(place.x, 0, std::max(0, picture.cols - size.width));
    place.y = std::clamp(place.y, size.height, std::max(size.height, picture.rows - 1));
    cv::putText(picture, text, place, kFont, kFontScale, colour, 1, cv::LINE_AA);
  }
};

/// A cross, or a point where a cross would hide the region.
void draw_centre(cv::Mat& picture, const Region& region, const cv::Scalar& colour) {
  constexpr int cross = 5;
  const cv::Rect box = box_of(region);
  const bool is_large = std::min(box.width, box.height) > 2 * cross;
  cv::drawMarker(picture, centre_of(region), colour, cv::MARKER_CROSS, is_large ? cross : 1);
}

/// Numbers of objects stand at the upper left corner of their box, where no hole's can be.
void draw_objects(cv::Mat& picture, const std::vector<Region>& objects) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    draw_centre(picture, objects[i], kObjectColour);
    const Label label(i + 1);
    const cv::Rect box = box_of(objects[i]);
    if (label.fits(box)) label.draw(picture, box.tl() - cv::Point(0, 2), kObjectColour);
  }
}

/// Those of holes stand beside the centre.
void draw_holes(cv::Mat& picture, const std::vector<Region>& holes) {
  for (std::size_t i = 0; i < holes.size(); ++i) {
    draw_centre(picture, holes[i], kHoleColour);
    const Label label(i + 1);
    if (!label.fits(box_of(holes[i]))) continue;
    label.draw(picture, centre_of(holes[i]) + cv::Point(3, -3), kHoleColour);
  }
}

}  // namespace

void write_overlay(const std::string& path, const ConstByteView& grey, const ConstByteView& objects,
                   const FoundHoles& found) {
  check_colour_ending(path);
  cv::Mat picture;
  cv::cvtColor(mat_of(grey), picture, cv::COLOR_GRAY2BGR);
  draw_outlines(picture, objects);
  draw_objects(picture, found.objects);
  draw_holes(picture, found.holes);
  write_mat(path, picture);
}

}  // namespace thinbench
