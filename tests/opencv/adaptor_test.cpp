// thinbench/opencv.hpp beside OpenCV's own functions.
#include <random>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <opencv2/ximgproc.hpp>

#include "thinbench/opencv.hpp"

namespace thinbench {
namespace {

cv::Mat random_grey(int seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  const int rows = static_cast<int>(random() % 60) + 1;
  const int columns = static_cast<int>(random() % 90) + 1;
  cv::Mat image(rows, columns, CV_8UC1);
  cv::RNG noise(static_cast<std::uint64_t>(seed));
  noise.fill(image, cv::RNG::UNIFORM, 0, 256);
  if (seed % 2 == 1) cv::blur(image, image, {5, 5});
  return image;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_L1) == 0;
}

cv::Mat thinned_by_opencv(const cv::Mat& source, int type) {
  cv::Mat result;
  cv::ximgproc::thinning(source, result, type);
  return result;
}

class ThinningOfMat : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(types, ThinningOfMat,
                         testing::Values(ximgproc::THINNING_ZHANGSUEN, ximgproc::THINNING_GUOHALL));

TEST_P(ThinningOfMat, equals_opencv_on_grey_images) {
  for (int seed = 0; seed < 300; ++seed) {
    const cv::Mat source = random_grey(seed);
    cv::Mat result;
    ximgproc::thinning(source, result, GetParam());
    ASSERT_TRUE(same(result, thinned_by_opencv(source, GetParam()))) << seed;
  }
}

TEST_P(ThinningOfMat, works_in_place_and_on_parts_of_an_image) {
  cv::Mat image = random_grey(7);
  cv::resize(image, image, {80, 60}, 0, 0, cv::INTER_NEAREST);
  const cv::Rect part(9, 5, 40, 30);
  const cv::Mat expected = thinned_by_opencv(image(part).clone(), GetParam());
  const cv::Mat outside_before = image.clone();
  cv::Mat view = image(part);
  ximgproc::thinning(view, view, GetParam());
  EXPECT_TRUE(same(image(part), expected));
  image(part).setTo(0);
  outside_before(part).setTo(0);
  EXPECT_TRUE(same(image, outside_before));
}

TEST_P(ThinningOfMat, takes_and_gives_umat) {
  const cv::Mat source = random_grey(8);
  cv::UMat input;
  source.copyTo(input);
  cv::UMat result;
  ximgproc::thinning(input, result, GetParam());
  EXPECT_TRUE(same(result.getMat(cv::ACCESS_READ), thinned_by_opencv(source, GetParam())));
}

TEST_P(ThinningOfMat, rejects_what_opencv_rejects) {
  cv::Mat result;
  EXPECT_THROW(ximgproc::thinning(cv::Mat(), result, GetParam()), cv::Exception);
  EXPECT_THROW(thinned_by_opencv(cv::Mat(), GetParam()), cv::Exception);
  for (const int type : {CV_32FC1, CV_8UC3, CV_16UC1}) {
    const cv::Mat source(3, 3, type);
    EXPECT_THROW(ximgproc::thinning(source, result, GetParam()), cv::Exception);
    EXPECT_THROW(thinned_by_opencv(source, GetParam()), cv::Exception);
  }
}

TEST(ThinningOfMat, rejects_an_unknown_type_and_writes_nothing) {
  cv::Mat result = cv::Mat::ones(3, 3, CV_8UC1);
  EXPECT_THROW(ximgproc::thinning(random_grey(1), result, 2), cv::Exception);
  EXPECT_TRUE(same(result, cv::Mat::ones(3, 3, CV_8UC1)));
}

/// Whether two label images are equal up to renumbering, and the statistics with them.
void expect_same_components(const cv::Mat& source, int connectivity) {
  cv::Mat labels[2];
  cv::Mat stats[2];
  cv::Mat centroids[2];
  const int count = thinbench::connectedComponentsWithStats(source, labels[0], stats[0],
                                                            centroids[0], connectivity);
  ASSERT_EQ(count, cv::connectedComponentsWithStats(source, labels[1], stats[1], centroids[1],
                                                    connectivity));
  ASSERT_TRUE(same(labels[0], labels[1]));
  for (int label = 0; label < count; ++label) {
    if (stats[1].at<int>(label, cv::CC_STAT_AREA) == 0) continue;  // no background
    EXPECT_TRUE(same(stats[0].row(label), stats[1].row(label)));
    EXPECT_LE(cv::norm(centroids[0].row(label), centroids[1].row(label)), 1e-9);
  }
}

TEST(ComponentsOfMat, equal_opencv) {
  for (int seed = 0; seed < 300; ++seed) {
    const cv::Mat source = random_grey(seed) > 100 + seed % 3 * 40;
    expect_same_components(source, 8);
    expect_same_components(source, 4);
  }
  expect_same_components(cv::Mat::zeros(4, 5, CV_8UC1), 8);
  expect_same_components(cv::Mat::ones(4, 5, CV_8UC1), 4);
}

TEST(ComponentsOfMat, take_parts_of_images_and_umat) {
  const cv::Mat source = random_grey(9) > 128;
  expect_same_components(source(cv::Rect(0, 0, source.cols / 2 + 1, source.rows)), 8);
  cv::UMat input;
  source.copyTo(input);
  cv::UMat labels;
  cv::UMat stats;
  cv::UMat centroids;
  cv::Mat expected;
  EXPECT_EQ(thinbench::connectedComponentsWithStats(input, labels, stats, centroids),
            cv::connectedComponents(source, expected));
  EXPECT_EQ(labels.type(), CV_32S);
}

TEST(ComponentsOfMat, reject_other_connectivities_and_types) {
  cv::Mat labels;
  cv::Mat stats;
  cv::Mat centroids;
  const cv::Mat image = cv::Mat::ones(3, 3, CV_8UC1);
  EXPECT_THROW(thinbench::connectedComponentsWithStats(image, labels, stats, centroids, 6),
               cv::Exception);
  EXPECT_THROW(thinbench::connectedComponentsWithStats(image, labels, stats, centroids, 8, CV_16U),
               cv::Exception);
  EXPECT_THROW(
      thinbench::connectedComponentsWithStats(cv::Mat(3, 3, CV_32F), labels, stats, centroids),
      cv::Exception);
}

TEST(EdgesOfMat, equal_those_of_views_also_in_place) {
  cv::Mat image = random_grey(10);
  cv::Mat expected(image.size(), CV_8UC1);
  detect_edges(EdgeOperator::sobel, ConstImageView(image.data, image.cols, image.rows),
               ImageView(expected.data, image.cols, image.rows));
  cv::UMat as_umat;
  image.copyTo(as_umat);
  detect_edges(EdgeOperator::sobel, as_umat, as_umat);
  EXPECT_TRUE(same(as_umat.getMat(cv::ACCESS_READ), expected));
  detect_edges(EdgeOperator::sobel, image, image);
  EXPECT_TRUE(same(image, expected));
  EXPECT_THROW(detect_edges(EdgeOperator::sobel, image, image, {.gradient_threshold = 300}),
               cv::Exception);
}

}  // namespace
}  // namespace thinbench
