// Thinning by OpenCV's ximgproc module. It keeps the border, so it belongs to the cases that do, to
// which it is equal in every pixel; how many iterations it took cannot be read from it.
#include <opencv2/core.hpp>
#include <opencv2/ximgproc.hpp>

#include "harness/library_operation.hpp"
#include "peers/mat_of.hpp"
#include "peers/peers.hpp"

namespace thinbench {
namespace {

Variant thinning_peer(const Operation& operation, cv::ximgproc::ThinningTypes type) {
  return peer_variant(
      "opencv", "OpenCV: ximgproc::thinning, which keeps the border",
      job_maker<NoNumbers>(
          [type, skeleton = cv::Mat()](const auto& input, const auto& output, auto&) mutable {
            if (input.width == 0 || input.height == 0) return;
            cv::ximgproc::thinning(mat_of(input), skeleton, type);
            skeleton.copyTo(mat_of(output));
          }),
      image_only(operation.reference));
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
