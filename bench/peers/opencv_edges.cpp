// Sobel edges by OpenCV, in the form in which it offers them: spatialGradient gives both gradients
// in one call. Its images are allocated beforehand, it runs on one thread.
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "harness/library_operation.hpp"
#include "peers/mat_of.hpp"
#include "peers/peers.hpp"

namespace thinbench {
namespace {

constexpr int kSobelScale = 4;

struct Gradients {
  cv::Mat gx;
  cv::Mat gy;
  cv::Mat brightest;
};

JobMaker sobel(bool with_brightness) {
  return job_maker<NoNumbers>(
      [with_brightness, own = Gradients()](const auto& input, const auto& output, auto&) mutable {
        if (input.width == 0 || input.height == 0) return;
        const EdgeThresholds thresholds;
        auto& [gx, gy, brightest] = own;
        const cv::Mat source = mat_of(input);
        cv::Mat edges = mat_of(output);
        cv::spatialGradient(source, gx, gy, 3, cv::BORDER_REPLICATE);
        cv::absdiff(gx, cv::Scalar(0), gx);
        cv::absdiff(gy, cv::Scalar(0), gy);
        cv::add(gx, gy, gx);
        cv::compare(gx, thresholds.gradient_threshold * kSobelScale, edges, cv::CMP_GT);
        if (!with_brightness) return;
        cv::dilate(source, brightest, cv::Mat());
        cv::compare(brightest, thresholds.brightness_threshold, brightest, cv::CMP_GT);
        cv::bitwise_and(edges, brightest, edges);
      });
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
