#include "images/regions.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include <opencv2/imgproc.hpp>

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

constexpr OverlayColour kObjectColour = {0, 170, 0};
constexpr OverlayColour kHoleColour = {255, 40, 40};

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

/// Those at these positions.
void add_outlines(Overlay& overlay, const std::vector<Outline>& outlines,
                  const std::vector<std::size_t>& positions, const OverlayColour& colour) {
  for (const std::size_t i : positions) {
    OverlayLine line = {{}, colour, true};
    line.points.reserve(outlines[i].contour.size());
    for (const cv::Point& p : outlines[i].contour) line.points.push_back({p.x, p.y});
    overlay.lines.push_back(std::move(line));
  }
}

Pixel size_of(const Region& region) {
  return {region.right - region.left + 1, region.bottom - region.top + 1};
}

Pixel centre_of(const Region& region) {
  return {cvRound(region.centre_x()), cvRound(region.centre_y())};
}

/// Whether a region is so large that numbers of its like leave the image readable.
bool is_numbered(const Region& region) {
  const Pixel digit = overlay_text_size("0");
  const Pixel size = size_of(region);
  return size.x > digit.x && size.y > digit.y;
}

/// A cross, or a point where a cross would hide the region.
void add_centre(Overlay& overlay, const Region& region, const OverlayColour& colour) {
  constexpr int arm = 2;
  const Pixel size = size_of(region), at = centre_of(region);
  if (std::min(size.x, size.y) <= 4 * arm + 2) {
    overlay.lines.push_back({{at}, colour});
    return;
  }
  overlay.lines.push_back({{{at.x - arm, at.y}, {at.x + arm, at.y}}, colour});
  overlay.lines.push_back({{{at.x, at.y - arm}, {at.x, at.y + arm}}, colour});
}

/// Numbers of objects stand above their first pixels, where no hole of theirs is.
void add_objects(Overlay& overlay, const std::vector<Region>& objects, const Outlines& outlines,
                 const KeptRegions& kept) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    add_centre(overlay, objects[i], kObjectColour);
    if (!is_numbered(objects[i])) continue;
    const cv::Point first = outlines.objects[kept.objects[i]].first;
    overlay.texts.push_back({{first.x, first.y - 2}, std::to_string(i + 1), kObjectColour});
  }
}

/// Those of holes stand beside the centre.
void add_holes(Overlay& overlay, const std::vector<Region>& holes) {
  for (std::size_t i = 0; i < holes.size(); ++i) {
    add_centre(overlay, holes[i], kHoleColour);
    if (!is_numbered(holes[i])) continue;
    const Pixel centre = centre_of(holes[i]);
    overlay.texts.push_back({{centre.x + 3, centre.y - 3}, std::to_string(i + 1), kHoleColour});
  }
}

}  // namespace

Overlay regions_overlay(const ConstImageView& objects, const Regions& found,
                        std::int64_t min_area) {
  const Outlines outlines = outlines_of(objects);
  const KeptRegions kept = kept_regions(found, min_area);
  Overlay overlay;
  add_outlines(overlay, outlines.objects, kept.objects, kObjectColour);
  add_outlines(overlay, outlines.holes, kept.holes, kHoleColour);
  const Regions shown = selected(found, kept);
  add_objects(overlay, shown.objects, outlines, kept);
  add_holes(overlay, shown.holes);
  return overlay;
}

}  // namespace thinbench
