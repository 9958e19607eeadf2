#include "thinbench/graph_labels.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "graph/label_loop.hpp"

namespace thinbench {
namespace {

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
