// Objects and holes by OpenCV, in the forms in which it offers them, on one thread, from bytes.
// None does all that `holes` does, so each is compared with what it gives.
#include <algorithm>
#include <array>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "holes.hpp"
#include "peers/mat_of.hpp"
#include "peers/peers.hpp"

namespace thinbench {
namespace {

constexpr int kEight = 8;

/// A job that gives numbers; images without pixels are not shown to OpenCV.
class CountingJob : public Job {
 public:
  CountingJob() { cv::setNumThreads(1); }
  void run(const ConstImageView& input, const ImageView&) final {
    numbers_.clear();
    if (input.width > 0 && input.height > 0) count(mat_of(input));
  }
  [[nodiscard]] std::vector<std::int64_t> numbers() const final { return numbers_; }
  [[nodiscard]] bool gives_image() const final { return false; }

 protected:
  virtual void count(const cv::Mat& source) = 0;
  std::vector<std::int64_t> numbers_;
};

/// Objects, holes; areas and centres of the polygons are computed and, not being those of the
/// pixels, compared with nothing.
class ContoursJob final : public CountingJob {
  void count(const cv::Mat& source) override {
    cv::findContours(source, contours_, hierarchy_, cv::RETR_CCOMP, cv::CHAIN_APPROX_SIMPLE);
    moments_.clear();
    std::int64_t holes = 0;
    for (std::size_t i = 0; i < contours_.size(); ++i) {
      moments_.push_back(cv::moments(contours_[i]));
      holes += hierarchy_[i][3] >= 0 ? 1 : 0;
    }
    numbers_ = {static_cast<std::int64_t>(contours_.size()) - holes, holes};
  }

  std::vector<std::vector<cv::Point>> contours_;
  std::vector<cv::Vec4i> hierarchy_;
  std::vector<cv::Moments> moments_;
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

class StatsJob final : public CountingJob {
  void count(const cv::Mat& source) override {
    const int labels = cv::connectedComponentsWithStats(source, labels_, stats_, centres_, kEight);
    objects_.clear();
    for (int label = 1; label < labels; ++label) {
      const int* of = stats_.ptr<int>(label);
      objects_.push_back({of[cv::CC_STAT_AREA], of[cv::CC_STAT_LEFT], of[cv::CC_STAT_TOP],
                          of[cv::CC_STAT_WIDTH], of[cv::CC_STAT_HEIGHT]});
    }
    numbers_ = flattened(objects_);
  }

  cv::Mat labels_;
  cv::Mat stats_;
  cv::Mat centres_;
  std::vector<AreaAndBox> objects_;
};

class ComponentsJob final : public CountingJob {
  void count(const cv::Mat& source) override {
    numbers_ = {cv::connectedComponents(source, labels_, kEight) - 1};
  }

  cv::Mat labels_;
};

/// What a peer gives, from the reference's lists.
template <class Numbers>
class ListReference final : public CountingJob {
  void count(const cv::Mat& source) override {
    numbers_ = Numbers{}(
        reference::holes({source.data, source.cols, source.rows, static_cast<Index>(source.step)}));
  }
};

struct ObjectsAndHoles {
  std::vector<std::int64_t> operator()(const reference::Regions& found) const {
    return {static_cast<std::int64_t>(found.objects.size()),
            static_cast<std::int64_t>(found.holes.size())};
  }
};

struct Objects {
  std::vector<std::int64_t> operator()(const reference::Regions& found) const {
    return {static_cast<std::int64_t>(found.objects.size())};
  }
};

struct AreasAndBoxes {
  std::vector<std::int64_t> operator()(const reference::Regions& found) const {
    std::vector<AreaAndBox> objects;
    for (const Region& object : found.objects) {
      objects.push_back({object.area, object.left, object.top, object.right - object.left + 1,
                         object.bottom - object.top + 1});
    }
    return flattened(std::move(objects));
  }
};

template <class MadeJob>
JobMaker maker() {
  return [](Index, Index, int) { return std::make_unique<MadeJob>(); };
}

}  // namespace

std::vector<Variant> opencv_holes_peers(const Operation& operation) {
  Variant contours =
      peer_variant("opencv_contours", "OpenCV: findContours (RETR_CCOMP) and moments of polygons",
                   maker<ContoursJob>(), maker<ListReference<ObjectsAndHoles>>());
  // Four times the pixels, and so the contours, take it more than twenty times as long.
  const Variant stats =
      peer_variant("opencv_stats", "OpenCV: connectedComponentsWithStats, objects without holes",
                   maker<StatsJob>(), maker<ListReference<AreasAndBoxes>>());
  const Variant components =
      peer_variant("opencv_components", "OpenCV: connectedComponents, objects without sums",
                   maker<ComponentsJob>(), maker<ListReference<Objects>>());
  if (operation.name == "holes") return {contours, stats};
  if (operation.name == "components") return {stats};
  if (operation.name == "euler_number") return {components};
  return {};
}

}  // namespace thinbench
