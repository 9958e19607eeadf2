#include "harness/image_names.hpp"

#include <algorithm>
#include <filesystem>

namespace thinbench {

std::string image_name(const std::string& path, const std::vector<std::string>& taken,
                       const std::regex& reserved) {
  const auto is_reserved = [&](const std::string& name) {
    return std::regex_match(name, reserved);
  };
  const auto is_free = [&](const std::string& name) {
    return !is_reserved(name) && std::find(taken.begin(), taken.end(), name) == taken.end();
  };
  std::string stem = std::filesystem::path(path).stem().string();
  if (is_free(stem)) return stem;
  // A number may make a reserved name, too: a second image file `square` is no square_2.
  if (is_reserved(stem) || is_reserved(stem + "_2")) stem += "_image";
  std::string name = stem;
  for (int i = 2; !is_free(name); ++i) name = stem + "_" + std::to_string(i);
  return name;
}

}  // namespace thinbench
