#include "cli/binarise_options.hpp"

#include <algorithm>

#include "cli/arguments.hpp"
#include "cli/names.hpp"

namespace thinbench {
namespace {

constexpr const char* kOtsu = "otsu";
constexpr int kMaxLevel = 255;

CLI::Option* add_foreground(CLI::App& app, Foreground& foreground) {
  const std::vector<std::string_view> names(kForegroundNames.begin(), kForegroundNames.end());
  const auto set = [&foreground, names](const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    foreground = static_cast<Foreground>(found - names.begin());
  };
  return app
      .add_option_function<std::string>("--foreground", set,
                                        "Which pixels are foreground: auto takes the class that "
                                        "covers less of the image border")
      ->check(one_of(names))
      ->type_name("bright|dark|auto")
      ->default_str(std::string(names.front()));
}

CLI::Option* add_threshold(CLI::App& app, std::optional<int>& threshold) {
  const auto set = [&threshold](const std::string& text) {
    threshold = text == kOtsu ? std::nullopt : std::optional(std::stoi(text));
  };
  return app
      .add_option_function<std::string>("--threshold", set,
                                        "Bright are grey levels >= N, 0 to 255; otsu: the level "
                                        "that separates the two classes best")
      ->check(integer_or(0, kMaxLevel, kOtsu))
      ->type_name("N|otsu")
      ->default_str(kOtsu);
}

}  // namespace

void add_binarise_options(CLI::App& app, BinariseOptions& options, CLI::Option* image) {
  for (CLI::Option* option :
       {add_foreground(app, options.foreground), add_threshold(app, options.threshold)}) {
    if (image != nullptr) option->needs(image);
  }
}

std::string binarise_words(const BinariseOptions& options) {
  std::string words;
  if (options.foreground != Foreground::automatic) {
    words.append(" --foreground ").append(foreground_name(options.foreground));
  }
  if (options.threshold) words.append(" --threshold ").append(std::to_string(*options.threshold));
  return words;
}

}  // namespace thinbench
