// Objects and holes by OpenCV, in the forms in which it offers them, on one thread, from bytes.
// None does all that `holes` does, so each is compared with what it gives.
#include <algorithm>
#include <array>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "harness/library_operation.hpp"
#include "peers/mat_of.hpp"
#include "peers/peers.hpp"

namespace thinbench {
namespace {

constexpr int kEight = 8;

struct Numbers {
  static constexpr bool kGivesImage = false;
  std::vector<std::int64_t> list;
  [[nodiscard]] std::vector<std::int64_t> numbers() const { return list; }
};

/// Images without pixels are not shown to OpenCV, nor to references of what it gives.
template <class Count>
JobMaker counting_peer(Count count) {
  return job_maker<Numbers>([count](const auto& input, const auto&, Numbers& found) mutable {
    found.list.clear();
    if (input.width > 0 && input.height > 0) found.list = count(input);
  });
}

/// Objects, holes; areas and centres of the polygons are computed and, not being those of the
/// pixels, compared with nothing.
struct Contours {
  std::vector<std::int64_t> operator()(const ConstImageView& image) {
    cv::findContours(mat_of(image), contours, hierarchy, cv::RETR_CCOMP, cv::CHAIN_APPROX_SIMPLE);
    moments.clear();
    std::int64_t holes = 0;
    for (std::size_t i = 0; i < contours.size(); ++i) {
      moments.push_back(cv::moments(contours[i]));
      holes += hierarchy[i][3] >= 0 ? 1 : 0;
    }
    return {static_cast<std::int64_t>(contours.size()) - holes, holes};
  }

  std::vector<std::vector<cv::Point>> contours;
  std::vector<cv::Vec4i> hierarchy;
  std::vector<cv::Moments> moments;
};

/// Area and box of each object, in the order of these numbers: OpenCV's own order is not by first
/// pixels.
using AreaAndBox = std::array<std::int64_t, 5>;

std::vector<std::int64_t> flattened(std::vector<AreaAndBox> objects) {
  std::sort(objects.begin(), objects.end());
  std::vector<std::int64_t> numbers;
  for (const AreaAndBox& object : objects) {
    numbers.insert(numbers.end(), object.begin(), object.end());
  }
  return numbers;
}

struct Stats {
  std::vector<std::int64_t> operator()(const ConstImageView& image) {
    const int count =
        cv::connectedComponentsWithStats(mat_of(image), labels, stats, centres, kEight);
    objects.clear();
    for (int label = 1; label < count; ++label) {
      const int* of = stats.ptr<int>(label);
      objects.push_back({of[cv::CC_STAT_AREA], of[cv::CC_STAT_LEFT], of[cv::CC_STAT_TOP],
                         of[cv::CC_STAT_WIDTH], of[cv::CC_STAT_HEIGHT]});
    }
    return flattened(objects);
  }

  cv::Mat labels;
  cv::Mat stats;
  cv::Mat centres;
  std::vector<AreaAndBox> objects;
};

struct Components {
  std::vector<std::int64_t> operator()(const ConstImageView& image) {
    return {cv::connectedComponents(mat_of(image), labels, kEight) - 1};
  }

  cv::Mat labels;
};

// What these give, from the reference's lists.

std::vector<std::int64_t> objects_and_holes(const ConstImageView& image) {
  const reference::Regions found = reference::holes(image);
  return {std::ssize(found.objects), std::ssize(found.holes)};
}

std::vector<std::int64_t> objects_alone(const ConstImageView& image) {
  return {std::ssize(reference::holes(image).objects)};
}

std::vector<std::int64_t> areas_and_boxes(const ConstImageView& image) {
  std::vector<AreaAndBox> objects;
  for (const Region& object : reference::holes(image).objects) {
    objects.push_back({object.area, object.left, object.top, object.right - object.left + 1,
                       object.bottom - object.top + 1});
  }
  return flattened(std::move(objects));
}

}  // namespace

std::vector<Variant> opencv_holes_peers(const Operation& operation) {
  Variant contours =
      peer_variant("opencv_contours", "OpenCV: findContours (RETR_CCOMP) and moments of polygons",
                   counting_peer(Contours()), counting_peer(&objects_and_holes));
  // Four times the pixels, and so the contours, take it more than twenty times as long.
  const Variant stats =
      peer_variant("opencv_stats", "OpenCV: connectedComponentsWithStats, objects without holes",
                   counting_peer(Stats()), counting_peer(&areas_and_boxes));
  const Variant components =
      peer_variant("opencv_components", "OpenCV: connectedComponents, objects without sums",
                   counting_peer(Components()), counting_peer(&objects_alone));
  if (operation.name == "holes") return {contours, stats};
  if (operation.name == "objects") return {stats};
  if (operation.name == "euler_number") return {components};
  return {};
}

}  // namespace thinbench
