#include "thinbench/graph_labels.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "graph/label_loop.hpp"
#include "support/rejection.hpp"

namespace thinbench {
namespace {

TEST(GraphOfLabels, lines_that_touch_stay_apart) {
  const LabelImage image = labels_of({"5552",  //
                                      "...2"});
  const LabelGraph found = graph_of_labels(image.view());
  EXPECT_EQ(found.labels, (std::vector<std::int32_t>{2, 2, 5, 5}));
  ASSERT_EQ(found.graph.edges.size(), 2U);
  EXPECT_EQ(length_of(found.graph.edges[0]), 1);
  EXPECT_EQ(length_of(found.graph.edges[1]), 2);
}

TEST(GraphOfLabels, equals_a_loop_over_the_labels) {
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    const LabelImage image = random_labels(random);
    ASSERT_TRUE(graph_of_labels(image.view()) == graph_of_each_label(image)) << "image " << i;
  }
}

TEST(GraphOfLabels, of_an_image_without_pixels_or_labels_is_empty) {
  const LabelImage background = labels_of({"...", "..."});
  EXPECT_TRUE(graph_of_labels(background.view()) == LabelGraph{});
  EXPECT_TRUE(graph_of_labels({nullptr, 0, 5}) == LabelGraph{});
  EXPECT_TRUE(graph_of_labels({nullptr, 5, 0}) == LabelGraph{});
}

TEST(LabelDistances, are_those_to_the_nearest_pixel_of_another_label) {
  const LabelImage image = labels_of({"11112", "11112", "11112"});
  std::vector<double> found(15);
  distances_of_labels(image.view(), {found.data(), 5, 3});
  EXPECT_EQ(std::vector<double>(found.begin(), found.begin() + 5),
            (std::vector<double>{4, 3, 2, 1, 1}));
}

TEST(LabelDistances, equal_a_loop_over_the_labels) {
  std::mt19937 random(2);
  const Spacing spacing = {.x = 2, .y = 0.5};
  for (int i = 0; i < 200; ++i) {
    const LabelImage image = random_labels(random);
    const std::size_t pixels = image.labels.size();
    std::vector<double> found(pixels), of_label(pixels), expected(pixels);
    distances_of_labels(image.view(), {found.data(), image.width, image.height}, spacing);
    for_each_label(image, [&](std::int32_t label, const ByteImage& mask) {
      distances(mask.view(), {of_label.data(), image.width, image.height}, spacing);
      for (std::size_t at = 0; at < pixels; ++at) {
        if (image.labels[at] == label) expected[at] = of_label[at];
      }
    });
    ASSERT_EQ(found, expected) << "image " << i;
  }
}

TEST(GraphOfLabels, views_that_do_not_fit_are_rejected) {
  const LabelImage image = labels_of({"12", "34"});
  std::vector<double> numbers(4);
  const auto* inside = reinterpret_cast<const std::int32_t*>(numbers.data());
  EXPECT_EQ(rejection_of([] {
              static_cast<void>(graph_of_labels({nullptr, 3, 3}));
            }),
            "labels has no data");
  EXPECT_EQ(rejection_of([&] {
              distances_of_labels(image.view(), {numbers.data(), 2, 1});
            }),
            "labels is 2 x 2 and distances 2 x 1; they must have the same size");
  EXPECT_EQ(rejection_of([&] {
              distances_of_labels({inside, 2, 2}, {numbers.data(), 2, 2});
            }),
            "labels and distances overlap");
}

TEST(PruneLabels, equals_a_loop_over_the_labels) {
  std::mt19937 random(3);
  const Pruning pruning = {.min_length = 3, .removes_components = true};
  for (int i = 0; i < 200; ++i) {
    LabelImage image = random_labels(random);
    LabelGraph expected;
    std::vector<std::int32_t> left(image.labels.size());
    for_each_label(image, [&](std::int32_t label, ByteImage mask) {
      append(expected, label, prune(mask.view(), mask.view(), pruning));
      for (std::size_t at = 0; at < left.size(); ++at) {
        const Index x = static_cast<Index>(at) % image.width;
        if (mask.at(x, static_cast<Index>(at) / image.width) != 0) left[at] = label;
      }
    });
    ASSERT_TRUE(prune_labels(image.view(), image.view(), pruning) == expected) << "image " << i;
    ASSERT_EQ(image.labels, left) << "image " << i;
  }
}

}  // namespace
}  // namespace thinbench
