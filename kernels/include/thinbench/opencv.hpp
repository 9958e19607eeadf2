// For programs that use OpenCV: thinning, components and edges of cv::Mat, with OpenCV's
// signatures. Header only; link thinbench and OpenCV's core. All functions are thread-safe for
// different destinations and throw cv::Exception with OpenCV's error codes.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "thinbench/edges.hpp"
#include "thinbench/regions.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {

namespace opencv_detail {

inline ConstImageView view_of(const cv::Mat& image) {
  return {image.data, image.cols, image.rows, static_cast<Index>(image.step)};
}

inline ImageView mutable_view_of(const cv::Mat& image) {
  return {image.data, image.cols, image.rows, static_cast<Index>(image.step)};
}

/// The input as a matrix; throws unless it is a 2-D image of one byte per pixel.
inline cv::Mat byte_image(cv::InputArray source) {
  CV_Assert(!source.empty());
  CV_Assert(source.dims() <= 2);
  CV_CheckTypeEQ(source.type(), CV_8UC1, "expected one byte per pixel");
  return source.getMat();
}

/// Calls a body and turns its errors into OpenCV's.
template <class Body>
auto with_opencv_errors(const Body& body) {
  try {
    return body();
  } catch (const std::invalid_argument& error) {
    CV_Error(cv::Error::StsBadArg, error.what());
  } catch (const std::bad_alloc&) {
    CV_Error(cv::Error::StsNoMem, "out of memory");
  }
}

/// A result that the caller may hold in any kind of array, made before it is moved there, so that
/// source and destination may be the same.
inline void give(const cv::Mat& result, cv::OutputArray destination) {
  result.copyTo(destination);
}

/// The region of label 0; without any pixel its sides are those of an empty rectangle at (0, 0).
inline Region background_of(const cv::Mat_<int>& labels) {
  Region region{0, 0, 0, labels.cols, labels.rows, -1, -1, 0};
  for (int y = 0; y < labels.rows; ++y) {
    for (int x = 0; x < labels.cols; ++x) {
      if (labels(y, x) != 0) continue;
      region.area += 1;
      region.sum_x += x;
      region.sum_y += y;
      region.left = std::min(region.left, x);
      region.right = std::max(region.right, x);
      region.top = std::min(region.top, y);
      region.bottom = y;
    }
  }
  return region.area > 0 ? region : Region{0, 0, 0, 0, 0, -1, -1, 0};
}

/// Writes a row per region: its bounding box and area, and its centre.
inline void give_statistics(const std::vector<Region>& regions, cv::OutputArray stats,
                            cv::OutputArray centroids) {
  const auto count = static_cast<int>(regions.size());
  cv::Mat_<int> numbers(count, 5);
  cv::Mat_<double> centres(count, 2);
  for (int label = 0; label < count; ++label) {
    const Region& region = regions[static_cast<std::size_t>(label)];
    const int row[5] = {region.left, region.top, region.right - region.left + 1,
                        region.bottom - region.top + 1, static_cast<int>(region.area)};
    std::copy_n(row, 5, numbers[label]);
    centres(label, 0) = region.centre_x();
    centres(label, 1) = region.centre_y();
  }
  give(numbers, stats);
  give(centres, centroids);
}

}  // namespace opencv_detail

namespace ximgproc {

enum ThinningTypes { THINNING_ZHANGSUEN = 0, THINNING_GUOHALL = 1 };

/// As cv::ximgproc::thinning, pixel for pixel: values of 128 and more are foreground, results are 0
/// and 255, and the outermost pixels are never removed. The destination may be the source or a part
/// of an image, and is written where it has the right size and type, even if it shares pixels with
/// the source, where OpenCV allocates another one.
///
/// Throws cv::Exception for an empty source, another type than CV_8UC1, and a thinning type that is
/// neither of the two, which OpenCV 4.6 accepts without thinning.
inline void thinning(cv::InputArray source, cv::OutputArray destination,
                     int thinning_type = THINNING_ZHANGSUEN, const Execution& execution = {}) {
  const cv::Mat image = opencv_detail::byte_image(source);
  if (thinning_type != THINNING_ZHANGSUEN && thinning_type != THINNING_GUOHALL) {
    CV_Error(cv::Error::StsBadArg, "thinningType: expected 0 (Zhang-Suen) or 1 (Guo-Hall), got " +
                                       std::to_string(thinning_type));
  }
  const Rule rule = thinning_type == THINNING_ZHANGSUEN ? Rule::zhang_suen : Rule::guo_hall;
  cv::Mat foreground = image >= 128;
  opencv_detail::with_opencv_errors([&] {
    const ImageView view = opencv_detail::mutable_view_of(foreground);
    return thin(rule, view, view, {.border = Border::keep}, execution);
  });
  opencv_detail::give(foreground, destination);
}

}  // namespace ximgproc

/// As cv::connectedComponentsWithStats, in numbers, too. `labels` is CV_32S; `stats` has a row of
/// CC_STAT_LEFT, TOP, WIDTH, HEIGHT and AREA per label, and `centroids` of x and y (CV_64F); label
/// 0 is the background. Returns the number of labels, with the background. Without background, the
/// sides of label 0 are 0.
///
/// Throws cv::Exception for an empty source, another type than CV_8UC1, a connectivity other than 8
/// and 4, and a label type other than CV_32S.
inline int connectedComponentsWithStats(cv::InputArray source, cv::OutputArray labels,
                                        cv::OutputArray stats, cv::OutputArray centroids,
                                        int connectivity = 8, int label_type = CV_32S) {
  const cv::Mat image = opencv_detail::byte_image(source);
  CV_CheckTypeEQ(label_type, CV_32S, "expected labels of 32 bits");
  CV_Check(connectivity, connectivity == 8 || connectivity == 4, "expected 8 or 4");
  cv::Mat_<int> painted(image.size());
  const std::vector<Region> objects = opencv_detail::with_opencv_errors([&] {
    const LabelView view(painted.ptr<std::int32_t>(), painted.cols, painted.rows,
                         static_cast<Index>(painted.step1()));
    return label_objects(opencv_detail::view_of(image), view,
                         static_cast<Connectivity>(connectivity), LabelOrder::opencv);
  });
  std::vector<Region> regions = {opencv_detail::background_of(painted)};
  regions.insert(regions.end(), objects.begin(), objects.end());
  opencv_detail::give(painted, labels);
  opencv_detail::give_statistics(regions, stats, centroids);
  return static_cast<int>(regions.size());
}

/// As detect_edges(), for a grey image of type CV_8UC1; the destination may be the source. Throws
/// cv::Exception where detect_edges() throws std::invalid_argument.
inline void detect_edges(EdgeOperator op, cv::InputArray source, cv::OutputArray destination,
                         const EdgeThresholds& thresholds = {}, const Execution& execution = {}) {
  const cv::Mat image = opencv_detail::byte_image(source);
  cv::Mat edges(image.size(), CV_8UC1);
  opencv_detail::with_opencv_errors([&] {
    detect_edges(op, opencv_detail::view_of(image), opencv_detail::mutable_view_of(edges),
                 thresholds, execution);
  });
  opencv_detail::give(edges, destination);
}

}  // namespace thinbench
