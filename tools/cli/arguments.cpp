#include "cli/arguments.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "cli/names.hpp"
#include "thinbench/options.hpp"

namespace thinbench {
namespace {

template <class Number>
std::optional<Number> number_from(const std::string& text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return number;
}

std::string expected(const std::string& what, const std::string& text) {
  return "expected " + what + ", got '" + text + "'";
}

/// "a number in [0, 2.5]".
template <class Number>
std::string number_range(const std::string& kind, Number lowest, Number highest) {
  std::ostringstream range;
  range << kind << " in [" << lowest << ", " << highest << "]";
  return range.str();
}

/// Takes numbers from `lowest` to `highest`, without the zeros in front; `what` names them.
template <class Number>
CLI::Validator number_in(Number lowest, Number highest, const std::string& what) {
  const auto check = [=](std::string& text) -> std::string {
    const auto number = number_from<Number>(text);
    if (!number || !(*number >= lowest && *number <= highest)) return expected(what, text);
    text = text.substr(std::min(text.find_first_not_of('0'), text.size() - 1));
    return {};
  };
  return {check, ""};  // help texts give the range in their own words
}

}  // namespace

CLI::Validator whole_number(std::uint64_t lowest, std::uint64_t highest) {
  return number_in(lowest, highest, number_range("an integer", lowest, highest));
}

CLI::Validator real_number(double lowest, double highest) {
  return number_in(lowest, highest, number_range("a number", lowest, highest));
}

CLI::Validator integer_or(std::uint64_t lowest, std::uint64_t highest, const std::string& word) {
  const std::string what = number_range("an integer", lowest, highest) + " or '" + word + "'";
  const auto check = [=, number = number_in(lowest, highest, what)](std::string& text) {
    return text == word ? std::string() : number(text);
  };
  return {check, ""};
}

CLI::Validator one_of(const std::vector<std::string_view>& names) {
  const auto check = [names](std::string& text) {
    const bool known = std::find(names.begin(), names.end(), text) != names.end();
    return known ? std::string() : expected(enumeration(names, " or "), text);
  };
  return {check, ""};
}

CLI::Validator not_empty() {
  return {
      [](std::string& text) { return text.empty() ? expected("a value", text) : std::string(); },
      ""};
}

void add_isa_option(CLI::App& app, std::optional<Isa>& isa) {
  app.add_option_function<std::string>(
         "--isa", [&isa](const std::string& name) { isa = isa_named(name); },
         "Instruction set (default: the highest)")
      ->check(not_empty())
      ->type_name("NAME");
}

void add_threads_option(CLI::App& app, int& threads) {
  app.add_option("--threads", threads, "Number of threads, 1 to " + std::to_string(kMaxThreads))
      ->check(whole_number(1, kMaxThreads))
      ->type_name("N")
      ->capture_default_str();
}

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
  CLI::Option* lenient =
      app.add_flag("--lenient", options.lenient,
                   "Read corrupt and truncated JPEG files as far as possible, with a warning");
  if (image != nullptr) lenient->needs(image);
}

std::string binarise_words(const BinariseOptions& options) {
  std::string words;
  if (options.foreground != Foreground::automatic) {
    words.append(" --foreground ").append(foreground_name(options.foreground));
  }
  if (options.threshold) words.append(" --threshold ").append(std::to_string(*options.threshold));
  if (options.lenient) words.append(" --lenient");
  return words;
}

}  // namespace thinbench
