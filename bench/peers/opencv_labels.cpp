// Label images by OpenCV, on one thread, from bytes. Its numbers are not in raster order with every
// algorithm, so labels are renumbered before they are compared.
#include <unordered_map>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "harness/library_operation.hpp"
#include "peers/mat_of.hpp"
#include "peers/peers.hpp"

namespace thinbench {
namespace {

struct CvLabels {
  static constexpr bool kGivesImage = false;
  cv::Mat labels;

  /// In raster order of first pixels, followed by two empty lists.
  [[nodiscard]] std::vector<std::int64_t> numbers() const {
    std::unordered_map<int, std::int64_t> numbers = {{0, 0}};
    std::vector<std::int64_t> found;
    for (int y = 0; y < labels.rows; ++y) {
      for (int x = 0; x < labels.cols; ++x) {
        const auto next = static_cast<std::int64_t>(numbers.size());
        found.push_back(numbers.try_emplace(labels.at<int>(y, x), next).first->second);
      }
    }
    found.insert(found.end(), {0, 0});
    return found;
  }
};

/// Images without pixels are not shown to OpenCV.
template <class Label>
JobMaker labelling(Label label) {
  return job_maker<CvLabels>([label](const auto& input, const auto&, CvLabels& found) mutable {
    if (input.width > 0 && input.height > 0) label(mat_of(input), found.labels);
  });
}

JobMaker components(int connectivity, int algorithm) {
  return labelling([=](const cv::Mat& source, cv::Mat& labels) {
    cv::connectedComponents(source, labels, connectivity, CV_32S, algorithm);
  });
}

JobMaker components_with_stats(int connectivity) {
  return labelling(
      [=, stats = cv::Mat(), centres = cv::Mat()](const cv::Mat& source, cv::Mat& labels) mutable {
        cv::connectedComponentsWithStats(source, labels, stats, centres, connectivity);
      });
}

std::vector<Variant> label_peers(int connectivity) {
  return {peer_variant("opencv_spaghetti", "OpenCV: connectedComponents (CCL_SPAGHETTI)",
                       components(connectivity, cv::CCL_SPAGHETTI)),
          peer_variant("opencv_bbdt", "OpenCV: connectedComponents (CCL_BBDT)",
                       components(connectivity, cv::CCL_BBDT)),
          peer_variant("opencv_sauf", "OpenCV: connectedComponents (CCL_SAUF)",
                       components(connectivity, cv::CCL_SAUF))};
}

/// Its table has no sums of coordinates but centres, so labels alone are compared.
std::vector<Variant> table_peers(int connectivity, const char* labels_alone) {
  return {peer_variant("opencv_stats",
                       "OpenCV: connectedComponentsWithStats, objects without holes",
                       components_with_stats(connectivity), operation_of(labels_alone).reference)};
}

}  // namespace

std::vector<Variant> opencv_labels_peers(const Operation& operation) {
  constexpr int four = 4;
  constexpr int eight = 8;
  if (operation.name == "label_image") return label_peers(eight);
  if (operation.name == "label_image_4") return label_peers(four);
  if (operation.name == "label_objects") return table_peers(eight, "label_image");
  if (operation.name == "label_objects_4") return table_peers(four, "label_image_4");
  return {};
}

}  // namespace thinbench
