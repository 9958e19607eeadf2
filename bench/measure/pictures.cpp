#include "measure/pictures.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "harness/operation.hpp"
#include "images/image_file.hpp"

namespace thinbench {
namespace {

void write_results(const std::string& stem, const TimedInput& input) {
  for (const Operation& operation : all_operations()) {
    if (operation.is_net || !operation.timed) continue;
    const ConstImageView view = input.view(operation);
    const auto reference = operation.reference(view.width, view.height, 1);
    if (!reference->gives_image()) continue;
    std::string name = operation.name;
    std::replace(name.begin(), name.end(), ':', '_');
    write_grey(fmt::format("{}_{}.png", stem, name), outcome_of(*reference, view).image.view());
  }
}

}  // namespace

void write_pictures(const std::vector<TimedInput>& inputs, const std::string& directory) {
  std::filesystem::create_directories(directory);
  for (const TimedInput& input : inputs) {
    const std::string stem = directory + "/" + input.name;
    write_grey(stem + ".png", input.binary.view());
    write_grey(stem + "_grey.png", input.grey.view());
    write_results(stem, input);
  }
}

}  // namespace thinbench
