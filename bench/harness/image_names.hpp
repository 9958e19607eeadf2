// Names of inputs that are made of image files.
#pragma once

#include <regex>
#include <string>
#include <vector>

namespace thinbench {

/// Of inputs of any kind that have a `name`.
template <class Input>
[[nodiscard]] std::vector<std::string> names_of(const std::vector<Input>& inputs) {
  std::vector<std::string> names;
  names.reserve(inputs.size());
  for (const Input& input : inputs) names.push_back(input.name);
  return names;
}

/// The file's name without directory and extension, unlike all `taken` names; holds no '/'. What
/// `reserved` matches is never given: to such a name "_image" is appended, which `reserved` must
/// let pass, with a number behind that, too.
[[nodiscard]] std::string image_name(const std::string& path, const std::vector<std::string>& taken,
                                     const std::regex& reserved);

}  // namespace thinbench
