// Label images by OpenCV, on one thread, from bytes. Its numbers are not in raster order with every
// algorithm, so labels are renumbered before they are compared.
#include <unordered_map>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "peers/mat_of.hpp"
#include "peers/peers.hpp"

namespace thinbench {
namespace {

/// A job that gives labels; images without pixels are not shown to OpenCV.
class LabelsJob : public Job {
 public:
  explicit LabelsJob(int connectivity) : connectivity_(connectivity) { cv::setNumThreads(1); }
  void run(const ConstImageView& input, const ImageView&) final {
    if (input.width > 0 && input.height > 0) label(mat_of(input), labels_);
  }
  [[nodiscard]] bool gives_image() const final { return false; }

  /// In raster order of first pixels, followed by two empty lists.
  [[nodiscard]] std::vector<std::int64_t> numbers() const final {
    std::unordered_map<int, std::int64_t> numbers = {{0, 0}};
    std::vector<std::int64_t> found;
    for (int y = 0; y < labels_.rows; ++y) {
      for (int x = 0; x < labels_.cols; ++x) {
        const auto next = static_cast<std::int64_t>(numbers.size());
        found.push_back(numbers.try_emplace(labels_.at<int>(y, x), next).first->second);
      }
    }
    found.insert(found.end(), {0, 0});
    return found;
  }

 protected:
  virtual void label(const cv::Mat& source, cv::Mat& labels) = 0;
  [[nodiscard]] int connectivity() const { return connectivity_; }

 private:
  int connectivity_;
  cv::Mat labels_;
};

class ComponentsJob final : public LabelsJob {
 public:
  ComponentsJob(int connectivity, int algorithm) : LabelsJob(connectivity), algorithm_(algorithm) {}

 private:
  void label(const cv::Mat& source, cv::Mat& labels) override {
    cv::connectedComponents(source, labels, connectivity(), CV_32S, algorithm_);
  }

  int algorithm_;
};

class StatsJob final : public LabelsJob {
 public:
  using LabelsJob::LabelsJob;

 private:
  void label(const cv::Mat& source, cv::Mat& labels) override {
    cv::connectedComponentsWithStats(source, labels, stats_, centres_, connectivity());
  }

  cv::Mat stats_;
  cv::Mat centres_;
};

std::vector<Variant> label_peers(int connectivity) {
  const auto with = [connectivity](int algorithm) {
    return
        [=](Index, Index, int) { return std::make_unique<ComponentsJob>(connectivity, algorithm); };
  };
  return {
      peer_variant("opencv_spaghetti", "OpenCV: connectedComponents (CCL_SPAGHETTI)",
                   with(cv::CCL_SPAGHETTI)),
      peer_variant("opencv_bbdt", "OpenCV: connectedComponents (CCL_BBDT)", with(cv::CCL_BBDT)),
      peer_variant("opencv_sauf", "OpenCV: connectedComponents (CCL_SAUF)", with(cv::CCL_SAUF))};
}

/// Its table has no sums of coordinates but centres, so labels alone are compared.
std::vector<Variant> table_peers(int connectivity, const char* labels_alone) {
  return {peer_variant(
      "opencv_stats", "OpenCV: connectedComponentsWithStats, objects without holes",
      [connectivity](Index, Index, int) { return std::make_unique<StatsJob>(connectivity); },
      operation_of(labels_alone).reference)};
}

}  // namespace

std::vector<Variant> opencv_labels_peers(const Operation& operation) {
  constexpr int four = 4;
  constexpr int eight = 8;
  if (operation.name == "label_image") return label_peers(eight);
  if (operation.name == "label_image_4") return label_peers(four);
  if (operation.name == "label_components") return table_peers(eight, "label_image");
  if (operation.name == "label_components_4") return table_peers(four, "label_image_4");
  return {};
}

}  // namespace thinbench
