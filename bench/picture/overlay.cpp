#include "picture/overlay.hpp"

#include <algorithm>
#include <tuple>

#include <opencv2/imgproc.hpp>

#include "picture/mat_of.hpp"
#include "picture/picture.hpp"
#include "picture/write_mat.hpp"

namespace thinbench {
namespace {

// Blue, green, red.
const cv::Scalar kObjectColour(0, 170, 0);
const cv::Scalar kHoleColour(40, 40, 255);

bool comes_before(const cv::Point& a, const cv::Point& b) {
  return std::tie(a.y, a.x) < std::tie(b.y, b.x);
}

/// Draws all outlines and returns the first pixel of each object, in the order of their ids.
std::vector<cv::Point> draw_outlines(cv::Mat& picture, const ConstImageView& objects) {
  std::vector<std::vector<cv::Point>> contours;
  std::vector<cv::Vec4i> hierarchy;
  cv::findContours(mat_of(objects), contours, hierarchy, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  std::vector<cv::Point> first_pixels;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const auto& contour = contours[i];
    const bool is_hole = hierarchy[i][3] >= 0;
    cv::polylines(picture, contour, true, is_hole ? kHoleColour : kObjectColour);
    if (is_hole) continue;
    first_pixels.push_back(*std::min_element(contour.begin(), contour.end(), comes_before));
  }
  std::sort(first_pixels.begin(), first_pixels.end(), comes_before);
  return first_pixels;
}

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kFontScale = 0.35;

cv::Rect box_of(const Region& region) {
  return {region.left, region.top, region.right - region.left + 1, region.bottom - region.top + 1};
}

cv::Point centre_of(const Region& region) {
  return {cvRound(region.centre_x()), cvRound(region.centre_y())};
}

cv::Size size_of(const std::string& text) {
  return cv::getTextSize(text, kFont, kFontScale, 1, nullptr);
}

/// Whether a region is so large that numbers of its like leave the picture readable.
bool is_numbered(const Region& region) {
  const cv::Size digit = size_of("0");
  const cv::Rect box = box_of(region);
  return box.width > digit.width && box.height > digit.height;
}

/// Writes an id with its lower left corner at `place`, moved so far that all lies in the picture.
void write_id(cv::Mat& picture, std::size_t id, cv::Point place, const cv::Scalar& colour) {
  const std::string text = std::to_string(id);
  const cv::Size size = size_of(text);
  place.x = std::clamp(place.x, 0, std::max(0, picture.cols - size.width));
  place.y = std::clamp(place.y, size.height, std::max(size.height, picture.rows - 1));
  cv::putText(picture, text, place, kFont, kFontScale, colour, 1, cv::LINE_AA);
}

/// A cross, or a point where a cross would hide the region.
void draw_centre(cv::Mat& picture, const Region& region, const cv::Scalar& colour) {
  constexpr int cross = 5;
  const cv::Rect box = box_of(region);
  const bool is_large = std::min(box.width, box.height) > 2 * cross;
  cv::drawMarker(picture, centre_of(region), colour, cv::MARKER_CROSS, is_large ? cross : 1);
}

/// Numbers of objects stand above their first pixels, where no hole of theirs is.
void draw_objects(cv::Mat& picture, const std::vector<Region>& objects,
                  const std::vector<cv::Point>& first_pixels) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    draw_centre(picture, objects[i], kObjectColour);
    if (!is_numbered(objects[i])) continue;
    write_id(picture, i + 1, first_pixels[i] - cv::Point(0, 2), kObjectColour);
  }
}

/// Those of holes stand beside the centre.
void draw_holes(cv::Mat& picture, const std::vector<Region>& holes) {
  for (std::size_t i = 0; i < holes.size(); ++i) {
    draw_centre(picture, holes[i], kHoleColour);
    if (!is_numbered(holes[i])) continue;
    write_id(picture, i + 1, centre_of(holes[i]) + cv::Point(3, -3), kHoleColour);
  }
}

}  // namespace

void write_overlay(const std::string& path, const ConstImageView& grey, const ConstImageView& objects,
                   const Regions& found) {
  check_colour_ending(path);
  cv::Mat picture;
  cv::cvtColor(mat_of(grey), picture, cv::COLOR_GRAY2BGR);
  const std::vector<cv::Point> first_pixels = draw_outlines(picture, objects);
  draw_objects(picture, found.objects, first_pixels);
  draw_holes(picture, found.holes);
  write_mat(path, picture);
}

}  // namespace thinbench
