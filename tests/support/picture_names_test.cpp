#include "support/picture_names.hpp"

#include <gtest/gtest.h>

namespace thinbench {
namespace {

using Names = std::vector<std::string>;

std::string named(const std::string& path, const Names& taken = {}) {
  return picture_name(path, taken, std::regex("scene|square_[0-9]+"));
}

TEST(PictureName, is_the_file_name_without_directory_and_extension) {
  EXPECT_EQ(named("a/b/horse.png"), "horse");
  EXPECT_EQ(named("horse.old.png"), "horse.old");
  EXPECT_EQ(named("horse"), "horse");
}

TEST(PictureName, has_the_first_free_number_appended_if_taken) {
  EXPECT_EQ(named("horse.png", {"horse"}), "horse_2");
  EXPECT_EQ(named("horse.png", {"horse", "horse_2", "horse_4"}), "horse_3");
}

TEST(PictureName, avoids_reserved_names_with_and_without_a_number) {
  EXPECT_EQ(named("scene.png"), "scene_picture");
  EXPECT_EQ(named("scene.png", {"scene_picture"}), "scene_picture_2");
  EXPECT_EQ(named("square.png"), "square");
  EXPECT_EQ(named("square.png", {"square"}), "square_picture");
  EXPECT_EQ(named("square.png", {"square", "square_picture"}), "square_picture_2");
}

}  // namespace
}  // namespace thinbench
