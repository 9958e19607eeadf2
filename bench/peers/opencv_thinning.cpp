// Thinning by OpenCV's ximgproc module. It keeps the border, so it belongs to the cases that do, to
// which it is equal in every pixel; how many iterations it took cannot be read from it.
#include <opencv2/core.hpp>
#include <opencv2/ximgproc.hpp>

#include "peers/mat_of.hpp"
#include "peers/peers.hpp"

namespace thinbench {
namespace {

class ThinningJob final : public Job {
 public:
  explicit ThinningJob(cv::ximgproc::ThinningTypes type) : type_(type) { cv::setNumThreads(1); }

  void run(const ConstImageView& input, const ImageView& output) override {
    if (input.width == 0 || input.height == 0) return;
    cv::ximgproc::thinning(mat_of(input), skeleton_, type_);
    skeleton_.copyTo(mat_of(output));
  }

 private:
  cv::ximgproc::ThinningTypes type_;
  cv::Mat skeleton_;
};

Variant thinning_peer(const Operation& operation, cv::ximgproc::ThinningTypes type) {
  Variant peer = peer_variant(
      "opencv", "OpenCV: ximgproc::thinning, which keeps the border",
      [type](Index, Index, int) { return std::make_unique<ThinningJob>(type); },
      image_only(operation.reference));
  return peer;
}

}  // namespace

std::vector<Variant> opencv_thinning_peers(const Operation& operation) {
  if (operation.name == "thin_zhang_suen:keep") {
    return {thinning_peer(operation, cv::ximgproc::THINNING_ZHANGSUEN)};
  }
  if (operation.name == "thin_guo_hall:keep") {
    return {thinning_peer(operation, cv::ximgproc::THINNING_GUOHALL)};
  }
  return {};
}

}  // namespace thinbench
