#include "harness/image_names.hpp"

#include <gtest/gtest.h>

namespace thinbench {
namespace {

using Names = std::vector<std::string>;

std::string named(const std::string& path, const Names& taken = {}) {
  return image_name(path, taken, std::regex("scene|square_[0-9]+"));
}

TEST(ImageName, is_the_files_without_directory_and_ending) {
  EXPECT_EQ(named("a/b/horse.png"), "horse");
  EXPECT_EQ(named("horse.old.png"), "horse.old");
  EXPECT_EQ(named("horse"), "horse");
}

TEST(ImageName, gets_the_first_free_number) {
  EXPECT_EQ(named("horse.png", {"horse"}), "horse_2");
  EXPECT_EQ(named("horse.png", {"horse", "horse_2", "horse_4"}), "horse_3");
}

TEST(ImageName, is_never_reserved_with_and_without_a_number) {
  EXPECT_EQ(named("scene.png"), "scene_image");
  EXPECT_EQ(named("scene.png", {"scene_image"}), "scene_image_2");
  EXPECT_EQ(named("square.png"), "square");
  EXPECT_EQ(named("square.png", {"square"}), "square_image");
  EXPECT_EQ(named("square.png", {"square", "square_image"}), "square_image_2");
}

}  // namespace
}  // namespace thinbench
