// Sobel edges by OpenCV, in the form in which it offers them: spatialGradient gives both gradients
// in one call. Its images are allocated beforehand, it runs on one thread.
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "harness/families.hpp"
#include "peers/mat_of.hpp"
#include "peers/peers.hpp"

namespace thinbench {
namespace {

constexpr int kSobelScale = 4;

class SobelJob final : public Job {
 public:
  explicit SobelJob(bool with_brightness) : with_brightness_(with_brightness) {
    cv::setNumThreads(1);
  }

  void run(const ConstImageView& input, const ImageView& output) override {
    if (input.width == 0 || input.height == 0) return;
    const cv::Mat source = mat_of(input);
    cv::Mat edges = mat_of(output);
    cv::spatialGradient(source, gx_, gy_, 3, cv::BORDER_REPLICATE);
    cv::absdiff(gx_, cv::Scalar(0), gx_);
    cv::absdiff(gy_, cv::Scalar(0), gy_);
    cv::add(gx_, gy_, gx_);
    cv::compare(gx_, thresholds_.gradient_threshold * kSobelScale, edges, cv::CMP_GT);
    if (!with_brightness_) return;
    cv::dilate(source, brightest_, cv::Mat());
    cv::compare(brightest_, thresholds_.brightness_threshold, brightest_, cv::CMP_GT);
    cv::bitwise_and(edges, brightest_, edges);
  }

 private:
  bool with_brightness_;
  EdgeThresholds thresholds_;
  cv::Mat gx_;
  cv::Mat gy_;
  cv::Mat brightest_;
};

JobMaker sobel(bool with_brightness) {
  return
      [with_brightness](Index, Index, int) { return std::make_unique<SobelJob>(with_brightness); };
}

}  // namespace

std::vector<Variant> opencv_edge_peers(const Operation& operation) {
  if (operation.name != "edges_sobel") return {};
  EdgeThresholds gradient_only;
  gradient_only.brightness_threshold = -1;
  return {peer_variant("opencv", "OpenCV: spatialGradient, dilate, both thresholds", sobel(true)),
          peer_variant("opencv_gradient", "OpenCV: spatialGradient and its threshold only",
                       sobel(false), edges_reference(EdgeOperator::sobel, gradient_only))};
}

std::string opencv_description() {
  return "OpenCV " + cv::getVersionString() + ", 1 thread, instruction sets of its own choice (" +
         cv::getCPUFeaturesLine() + ")";
}

}  // namespace thinbench
