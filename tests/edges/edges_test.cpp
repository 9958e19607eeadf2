// Thresholds, packed edges and the preferred variants; the references against an implementation of
// the same formulae by filters of OpenCV.
#include "thinbench/edges.hpp"

#include <algorithm>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "harness/families.hpp"
#include "harness/test_images.hpp"
#include "harness/verify.hpp"
#include "peers/mat_of.hpp"
#include "reference.hpp"
#include "scene/scene.hpp"
#include "support/margins.hpp"
#include "techniques/variants.hpp"

namespace thinbench {
namespace {

using detail::EdgeOperation;
using detail::study::edge_operations;

TEST(EdgeThresholds, every_variant_equals_its_reference_at_extreme_thresholds) {
  const ByteImage image = grey_noise_image(199, 41, 0, 255, 3);
  for (const EdgeOperation& edges : edge_operations()) {
    for (const EdgeThresholds& thresholds :
         {EdgeThresholds{0, 0}, EdgeThresholds{1, 1}, EdgeThresholds{127, 127},
          EdgeThresholds{128, 254}, EdgeThresholds{255, 0}, EdgeThresholds{0, 255}}) {
      const Operation operation = edges_operation(edges, thresholds);
      for (const Variant& variant : operation.variants) {
        if (!variant.unavailable_reason(199).empty()) continue;
        const auto job = variant.make_job(199, 41, variant.threaded ? 3 : 1);
        EXPECT_EQ(find_mismatch(*job, image.view(), expected_of(operation, variant, image.view())),
                  std::nullopt)
            << operation.name << " " << variant.technique << " " << isa_name(variant.isa);
      }
    }
  }
}

TEST(PackedEdges, equal_the_reference_and_leave_the_margin_zero) {
  const ByteImage image = grey_noise_image(131, 20, 0, 255, 5);
  for (const EdgeOperatorInfo& info : kEdgeOperators) {
    ByteImage expected(131, 20);
    reference::edges(info.op)({}, image.view(), expected.view());
    for (const Isa isa : all_isas()) {
      if (!isa_available(isa)) continue;
      detail::PackedEdges packed({{info.op, {}}, isa, 131, 20, 3});
      const detail::ConstBitPlaneView bits = packed.run(image.view());
      for (Index y = 0; y < 20; ++y) {
        for (Index x = 0; x < 131; ++x) {
          const bool is_edge = (bits.row(y)[x / 64] >> (x % 64) & 1) != 0;
          ASSERT_EQ(is_edge, expected.at(x, y) != 0) << info.name << " at " << isa_name(isa);
        }
      }
      EXPECT_TRUE(margin_is_zero(bits)) << info.name << " at " << isa_name(isa);
    }
  }
}

TEST(EdgeVariants, prefer_8_bit_lanes_if_available_and_16_bit_lanes_otherwise) {
  for (const EdgeOperation& operation : edge_operations()) {
    const bool has_8_bit =
        std::any_of(operation.variants.begin(), operation.variants.end(),
                    [](const auto& one) { return one.technique == "simd_8bit"; });
    const auto& chosen = detail::choose_variant(operation.variants, 100, 10, {});
    EXPECT_EQ(chosen.technique, has_8_bit ? "simd_8bit" : "simd_16bit") << operation.name;
  }
}

constexpr EdgeThresholds kThresholds[] = {{40, 128}, {0, 0}, {1, 254}, {12, 60}, {200, 20}};

struct Kernels {
  cv::Mat gx;
  cv::Mat gy;
  int scale;
};

Kernels kernels_of(EdgeOperator op) {
  const auto mat = [](int size, std::initializer_list<float> values) {
    return cv::Mat(std::vector<float>(values), true).reshape(1, size);
  };
  if (op == EdgeOperator::roberts4) {
    return {mat(3, {0, 0, 0, 0, 1, 0, 0, 0, -1}), mat(3, {0, 0, 0, 0, 0, 1, 0, -1, 0}), 2};
  }
  if (op == EdgeOperator::roberts9) {
    return {mat(3, {1, 0, 0, 0, 0, 0, 0, 0, -1}), mat(3, {0, 0, 1, 0, 0, 0, -1, 0, 0}), 2};
  }
  if (op == EdgeOperator::sobel) {
    return {mat(3, {-1, 0, 1, -2, 0, 2, -1, 0, 1}), mat(3, {-1, -2, -1, 0, 0, 0, 1, 2, 1}), 4};
  }
  if (op == EdgeOperator::prewitt) {
    return {mat(3, {-1, 0, 1, -1, 0, 1, -1, 0, 1}), mat(3, {-1, -1, -1, 0, 0, 0, 1, 1, 1}), 3};
  }
  if (op == EdgeOperator::mero_vassy) {
    return {mat(3, {0, 1, 1, -1, 0, 1, -1, -1, 0}), mat(3, {-1, -1, 0, -1, 0, 1, 0, 1, 1}), 4};
  }
  return {
      mat(5, {0, 1, 1, 1, 1, -1, 0, 1, 1, 1, -1, -1, 0, 1, 1, -1, -1, -1, 0, 1, -1, -1, -1, -1, 0}),
      mat(5, {-1, -1, -1, -1, 0, -1, -1, -1, 0, 1, -1, -1, 0, 1, 1, -1, 0, 1, 1, 1, 0, 1, 1, 1, 1}),
      12};
}

cv::Mat filtered(const ByteImage& image, const cv::Mat& kernel) {
  cv::Mat result;
  cv::filter2D(mat_of(image.view()), result, CV_32F, kernel, {-1, -1}, 0, cv::BORDER_REPLICATE);
  return result;
}

ByteImage edges_by_opencv(EdgeOperator op, const ByteImage& image,
                          const EdgeThresholds& thresholds) {
  const Kernels kernels = kernels_of(op);
  const cv::Mat magnitude =
      cv::abs(filtered(image, kernels.gx)) + cv::abs(filtered(image, kernels.gy));
  cv::Mat brightest;
  cv::dilate(mat_of(image.view()), brightest, cv::Mat());
  ByteImage result(image.width(), image.height());
  cv::Mat edges = (magnitude > thresholds.gradient_threshold * kernels.scale) &
                  (brightest > thresholds.brightness_threshold);
  edges.copyTo(mat_of(result.view()));
  return result;
}

class EdgesAgainstOpenCv : public testing::TestWithParam<EdgeOperator> {
 protected:
  static void expect_equal(const ByteImage& image, const std::string& what) {
    for (const EdgeThresholds& thresholds : kThresholds) {
      const ConstImageView view = image.view();
      const auto job = edges_reference(GetParam(), thresholds)(view.width, view.height, 1);
      const ByteImage expected = edges_by_opencv(GetParam(), image, thresholds);
      EXPECT_TRUE(equal(outcome_of(*job, view).image.view(), expected.view()))
          << what << ", P1 " << thresholds.gradient_threshold << ", P2 "
          << thresholds.brightness_threshold;
    }
  }
};

TEST_P(EdgesAgainstOpenCv, equal_on_the_scene) {
  const Scene scene = render_scene();
  expect_equal(scene.grey, "scene");
}

TEST_P(EdgesAgainstOpenCv, equal_on_noise_of_odd_sizes) {
  for (const auto& [width, height] :
       {std::pair<Index, Index>{1, 1}, {1, 9}, {9, 1}, {2, 2}, {5, 3}, {67, 31}, {129, 40}}) {
    const ByteImage image = grey_noise_image(width, height, 0, 255, 7);
    expect_equal(image, std::to_string(width) + " x " + std::to_string(height));
  }
}

std::vector<EdgeOperator> all_operators() {
  std::vector<EdgeOperator> operators;
  for (const EdgeOperatorInfo& info : kEdgeOperators) operators.push_back(info.op);
  return operators;
}

INSTANTIATE_TEST_SUITE_P(All, EdgesAgainstOpenCv, testing::ValuesIn(all_operators()),
                         [](const auto& tested) {
                           return std::string(edge_operator_info(tested.param).name);
                         });

TEST(MeroVassy, gradient_of_3x3_is_the_larger_of_sobels_gradients) {
  const ByteImage image = grey_noise_image(131, 67, 0, 255, 9);
  const Kernels sobel = kernels_of(EdgeOperator::sobel);
  const cv::Mat gx = cv::abs(filtered(image, sobel.gx));
  const cv::Mat gy = cv::abs(filtered(image, sobel.gy));
  const cv::Mat larger = cv::max(gx, gy);
  for (const int threshold : {20, 60, 120}) {
    ByteImage found(image.width(), image.height());
    detect_edges(EdgeOperator::mero_vassy, image.view(), found.view(), {threshold, 0});
    const cv::Mat expected = larger > threshold * sobel.scale;
    EXPECT_GT(cv::countNonZero(expected), 0) << threshold;
    EXPECT_EQ(cv::norm(expected, mat_of(found.view()), cv::NORM_INF), 0) << threshold;
  }
}

}  // namespace
}  // namespace thinbench
