// Images that are not part of the project; tests that need them are skipped if there are none.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace thinbench {

/// THINBENCH_TEST_IMAGES from the environment, else a directory beside the project.
inline std::filesystem::path external_image_directory() {
  const char* chosen = std::getenv("THINBENCH_TEST_IMAGES");
  return chosen != nullptr ? chosen : THINBENCH_IMAGES_BESIDE;
}

/// PNG and JPEG files in that directory; empty if it does not exist.
inline std::vector<std::string> external_images() {
  std::vector<std::string> paths;
  std::error_code ignored;
  for (const auto& entry :
       std::filesystem::directory_iterator(external_image_directory(), ignored)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".png" || extension == ".jpg") paths.push_back(entry.path().string());
  }
  return paths;
}

}  // namespace thinbench
