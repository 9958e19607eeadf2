#include "images/regions.hpp"

#include <algorithm>
#include <tuple>

#include <opencv2/imgproc.hpp>

#include "images/image_file.hpp"
#include "images/mat_of.hpp"

namespace thinbench {

KeptRegions kept_regions(const Regions& found, std::int64_t min_area) {
  const auto is_large = [&](const Region& region) { return region.area >= min_area; };
  KeptRegions kept;
  for (std::size_t i = 0; i < found.objects.size(); ++i) {
    if (is_large(found.objects[i])) kept.objects.push_back(i);
  }
  for (std::size_t i = 0; i < found.holes.size(); ++i) {
    const Region& hole = found.holes[i];
    if (is_large(hole) && is_large(found.objects[hole.enclosing_object - 1]))
      kept.holes.push_back(i);
  }
  return kept;
}

Regions selected(const Regions& found, const KeptRegions& kept) {
  Regions result;
  std::vector<std::uint32_t> new_ids(found.objects.size() + 1);
  for (const std::size_t i : kept.objects) {
    result.objects.push_back(found.objects[i]);
    new_ids[i + 1] = static_cast<std::uint32_t>(result.objects.size());
  }
  for (const std::size_t i : kept.holes) {
    result.holes.push_back(found.holes[i]);
    result.holes.back().enclosing_object = new_ids[found.holes[i].enclosing_object];
  }
  return result;
}

namespace {

// Blue, green, red.
const cv::Scalar kObjectColour(0, 170, 0);
const cv::Scalar kHoleColour(40, 40, 255);

bool comes_before(const cv::Point& a, const cv::Point& b) {
  return std::tie(a.y, a.x) < std::tie(b.y, b.x);
}

using Contour = std::vector<cv::Point>;

/// An outline and its first pixel, by rows and from the left.
struct Outline {
  cv::Point first;
  Contour contour;
};

/// Outlines by region: those of objects, and those round holes.
struct Outlines {
  std::vector<Outline> objects;
  std::vector<Outline> holes;
};

/// Both lists in the order of the regions' ids. An object's outline begins with its first pixel;
/// that round a hole, which lies on the object, with the pixel above the hole's first.
Outlines outlines_of(const ConstImageView& objects) {
  std::vector<Contour> contours;
  std::vector<cv::Vec4i> hierarchy;
  cv::findContours(mat_of(objects), contours, hierarchy, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  Outlines outlines;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const cv::Point first = *std::min_element(contours[i].begin(), contours[i].end(), comes_before);
    const bool is_hole = hierarchy[i][3] >= 0;
    (is_hole ? outlines.holes : outlines.objects).push_back({first, std::move(contours[i])});
  }
  const auto in_order = [](const Outline& a, const Outline& b) {
    return comes_before(a.first, b.first);
  };
  std::sort(outlines.objects.begin(), outlines.objects.end(), in_order);
  std::sort(outlines.holes.begin(), outlines.holes.end(), in_order);
  return outlines;
}

/// Draws the outlines at these positions.
void draw_outlines(cv::Mat& image, const std::vector<Outline>& outlines,
                   const std::vector<std::size_t>& positions, const cv::Scalar& colour) {
  for (const std::size_t i : positions) {
    cv::polylines(image, outlines[i].contour, true, colour);
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

cv::Size size_of(const std::string& text) {
  return cv::getTextSize(text, kFont, kFontScale, 1, nullptr);
}

/// Whether a region is so large that numbers of its like leave the image readable.
bool is_numbered(const Region& region) {
  const cv::Size digit = size_of("0");
  const cv::Rect box = box_of(region);
  return box.width > digit.width && box.height > digit.height;
}

/// Writes an id with its lower left corner at `place`, moved so far that all lies in the image.
void write_id(cv::Mat& image, std::size_t id, cv::Point place, const cv::Scalar& colour) {
  const std::string text = std::to_string(id);
  const cv::Size size = size_of(text);
  place.x = std::clamp(place.x, 0, std::max(0, image.cols - size.width));
  place.y = std::clamp(place.y, size.height, std::max(size.height, image.rows - 1));
  cv::putText(image, text, place, kFont, kFontScale, colour, 1, cv::LINE_AA);
}

/// A cross, or a point where a cross would hide the region.
void draw_centre(cv::Mat& image, const Region& region, const cv::Scalar& colour) {
  constexpr int cross = 5;
  const cv::Rect box = box_of(region);
  const bool is_large = std::min(box.width, box.height) > 2 * cross;
  cv::drawMarker(image, centre_of(region), colour, cv::MARKER_CROSS, is_large ? cross : 1);
}

/// Numbers of objects stand above their first pixels, where no hole of theirs is.
void draw_objects(cv::Mat& image, const std::vector<Region>& objects, const Outlines& outlines,
                  const KeptRegions& kept) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    draw_centre(image, objects[i], kObjectColour);
    if (!is_numbered(objects[i])) continue;
    const cv::Point first = outlines.objects[kept.objects[i]].first;
    write_id(image, i + 1, first - cv::Point(0, 2), kObjectColour);
  }
}

/// Those of holes stand beside the centre.
void draw_holes(cv::Mat& image, const std::vector<Region>& holes) {
  for (std::size_t i = 0; i < holes.size(); ++i) {
    draw_centre(image, holes[i], kHoleColour);
    if (!is_numbered(holes[i])) continue;
    write_id(image, i + 1, centre_of(holes[i]) + cv::Point(3, -3), kHoleColour);
  }
}

cv::Mat overlay(const ConstImageView& grey, const ConstImageView& objects, const Regions& found,
                std::int64_t min_area) {
  cv::Mat image;
  cv::cvtColor(mat_of(grey), image, cv::COLOR_GRAY2BGR);
  const Outlines outlines = outlines_of(objects);
  const KeptRegions kept = kept_regions(found, min_area);
  draw_outlines(image, outlines.objects, kept.objects, kObjectColour);
  draw_outlines(image, outlines.holes, kept.holes, kHoleColour);
  const Regions shown = selected(found, kept);
  draw_objects(image, shown.objects, outlines, kept);
  draw_holes(image, shown.holes);
  return image;
}

}  // namespace

void write_overlay(const std::string& path, const ConstImageView& grey,
                   const ConstImageView& objects, const Regions& found, std::int64_t min_area) {
  check_colour_extension(path);
  write_mat(path, [&] { return overlay(grey, objects, found, min_area); });
}

}  // namespace thinbench
