// Pictures that are no part of the project: tests that want them are skipped where there are none.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace thinbench {

/// The folder that THINBENCH_TEST_IMAGES names, else one beside the project.
inline std::filesystem::path external_image_directory() {
  const char* chosen = std::getenv("THINBENCH_TEST_IMAGES");
  return chosen != nullptr ? chosen : THINBENCH_IMAGES_BESIDE;
}

/// Its pictures; none where there is no such folder.
inline std::vector<std::string> external_images() {
  std::vector<std::string> paths;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(external_image_directory(), none)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".png" || ending == ".jpg") paths.push_back(entry.path().string());
  }
  return paths;
}

}  // namespace thinbench
