#include "cli/arguments.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <regex>
#include <sstream>
#include <system_error>

#include <fmt/format.h>

#include "cli/names.hpp"
#include "images/codecs.hpp"
#include "support/text.hpp"
#include "support/usage.hpp"
#include "support/whole_file.hpp"
#include "thinbench/options.hpp"

namespace thinbench {
namespace {

constexpr double kMaxNumber = 1e300;  // of image files

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

CLI::Validator printable() {
  return {[](std::string& text) {
            return text.empty() || !is_printable(text)
                       ? expected("UTF-8 without control characters", one_line(text))
                       : std::string();
          },
          ""};
}

CLI::Validator file_name() {
  return {[](std::string& text) {
            return text.empty() || text == "-" ? expected("the name of a file", text)
                                               : std::string();
          },
          ""};
}

CLI::Option* add_file_option(CLI::App& app, const std::string& name, std::string& path,
                             const std::string& what, const CLI::Validator& check) {
  return add_value(app, name, path, what, check, "FILE");
}

void add_input(CLI::App& app, std::string& in) {
  add_argument(app, "IN", in, "Image to read; - reads standard input");
}

void add_overlay_option(CLI::App& app, std::string& path) {
  add_value(app, "--overlay", path,
            "Image to write, with all that was found drawn on it: .svg, .png, .bmp, .tif, or "
            "- for PNG on standard output",
            not_empty(), "OUT");
}

void check_outputs(const std::vector<std::string>& inputs,
                   const std::vector<std::string>& outputs) {
  const auto is_file = [](const std::string& path) {
    return !path.empty() && path != kStandardStream;
  };
  std::error_code ignored;
  std::vector<std::string> known;
  for (const std::string& path : inputs) {
    if (is_file(path))
      known.push_back(weakly_canonical(absolute(std::filesystem::path(path)), ignored));
  }
  for (const std::string& path : outputs) {
    if (!is_file(path)) continue;
    check_target(path);
    const std::string place = place_of(path);
    const auto is_same = [&](const std::string& other) {
      return other == place || std::filesystem::equivalent(other, place, ignored);
    };
    if (std::ranges::any_of(known, is_same)) {
      throw UsageError("'" + path + "' is read or written as another file, too; give each its own");
    }
    known.push_back(place);
  }
}

void check_streams(bool json, const std::vector<std::string>& images) {
  if (!json || std::ranges::count(images, kStandardStream) == 0) return;
  throw UsageError("--json is printed on standard output, so an image needs the name of a file");
}

void check_replaced(const FileBytes& in, const std::string& out) {
  std::error_code ignored;
  if (!std::filesystem::equivalent(in.name(), out, ignored)) return;
  const std::size_t pages = pages_in(in).size();
  if (pages == 1) return;
  throw UsageError(fmt::format(
      "'{}' has {} pages, of which one would remain; give OUT another name, or use 'batch'", out,
      pages));
}

void check_sides(const std::string& file, Index width, Index height) {
  if (std::max(width, height) <= kMaxDistanceSide) return;
  throw FileError(fmt::format("{}: expected sides of at most {} pixels, got {} x {}", file,
                              kMaxDistanceSide, width, height));
}

void add_isa_option(CLI::App& app, std::optional<Isa>& isa) {
  add_value(
      app, "--isa", [&isa](const std::string& name) { isa = isa_named(name); },
      "Highest instruction set to use (default: all)", not_empty(), "NAME");
}

void add_threads_option(CLI::App& app, int& threads) {
  add_value(app, "--threads", threads, "Number of threads, 1 to " + std::to_string(kMaxThreads),
            whole_number(1, kMaxThreads), "N")
      ->capture_default_str();
}

namespace {

/// A number or, instead, one of the words.
CLI::Validator number_or(const std::vector<std::string_view>& words) {
  const std::string what = "a number, '" + enumeration(words, "' or '") + "'";
  const auto check = [=, number = number_in(-kMaxNumber, kMaxNumber, what)](std::string& text) {
    const bool is_word = std::find(words.begin(), words.end(), text) != words.end();
    return is_word ? std::string() : number(text);
  };
  return {check, ""};
}

CLI::Validator odd_number(std::uint64_t lowest, std::uint64_t highest) {
  const std::string what = number_range("an odd integer", lowest, highest);
  const auto check = [=, number = number_in(lowest, highest, what)](std::string& text) {
    const std::string wrong = number(text);
    return wrong.empty() && text.back() % 2 == 0 ? expected(what, text) : wrong;
  };
  return {check, ""};
}

constexpr const char* kOtsu = "otsu";
constexpr const char* kLocal = "local";

void add_foreground(CLI::App& app, Foreground& foreground) {
  const std::vector<std::string_view> names(kForegroundNames.begin(), kForegroundNames.end());
  const auto set = [&foreground](const std::string& name) {
    foreground = foreground_from_name(name).value();
  };
  add_value(app, "--foreground", set,
            "Which pixels are foreground: auto takes the class that "
            "covers less of the image border",
            one_of(names), "bright|dark|auto")
      ->default_str(std::string(names.front()));
}

CLI::Option* add_threshold(CLI::App& app, BinariseOptions& options) {
  const auto set = [&options](const std::string& text) {
    options.threshold.reset();
    options.local.reset();
    if (text == kLocal) options.local.emplace();
    if (text != kLocal && text != kOtsu) options.threshold = number_from<double>(text);
  };
  return add_value(app, "--threshold", set,
                   "Bright are grey levels >= N, in the numbers of the file; otsu: the level that "
                   "separates the two classes "
                   "best; local: for uneven light, the mean of the window around each pixel",
                   number_or({kOtsu, kLocal}), "N|otsu|local")
      ->default_str(kOtsu);
}

/// --window and --offset, which take effect after --threshold local.
void add_local(CLI::App& app, BinariseOptions& options, const CLI::Option* threshold) {
  const auto check = [threshold](const char* name) {
    if (threshold->count() > 0 && threshold->results().back() == kLocal) return;
    throw UsageError(std::string(name) + " needs --threshold local");
  };
  const auto set_window = [&options, check](const std::string& text) {
    check("--window");
    if (!options.local) options.local.emplace();
    options.local->window = std::stoi(text);
  };
  const auto set_offset = [&options, check](const std::string& text) {
    check("--offset");
    options.offset = number_from<double>(text);
  };
  add_value(app, "--window", set_window,
            "Side of the window, odd, 3 to 65535 (default: an eighth of the "
            "smaller side, at least 15)",
            odd_number(3, 65535), "N");
  add_value(app, "--offset", set_offset,
            "How far foreground is above or below the mean, in the numbers of the file (default: "
            "10, of 16 bits as large a share of their range)",
            real_number(0, kMaxNumber), "N");
}

constexpr const char* kOpacity = "alpha";

void add_channel(CLI::App& app, GreyChoice& choice) {
  std::vector<std::string_view> names(kChannelNames.begin(), kChannelNames.end());
  const auto set = [&choice](const std::string& name) {
    choice.opacity = name == kOpacity;
    if (!choice.opacity) choice.channel = channel_from_name(name).value();
  };
  names.emplace_back(kOpacity);
  add_value(app, "--channel", set,
            "What becomes the grey level of a colour; auto: what "
            "separates the two classes best; alpha: the opacity",
            one_of(names), "grey|red|green|blue|saturation|value|auto|alpha")
      ->default_str(std::string(names.front()));
}

void add_background(CLI::App& app, std::optional<Backdrop>& backdrop) {
  const auto set = [&backdrop](const std::string& name) {
    backdrop = name == "white" ? Backdrop::white : Backdrop::black;
  };
  add_value(
      app, "--background", set,
      "What shows through where an image is transparent (default: the colours stored there, of "
      "TIFF black)",
      one_of({"white", "black"}), "white|black");
}

/// From "10,20,300x200".
Crop crop_from(const std::string& text) {
  const auto numbers = whole_numbers(text, "N,N,NxN", 10);
  if (!numbers.empty() && numbers[2] > 0 && numbers[3] > 0) {
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
  }
  throw UsageError("--crop: expected X,Y,WIDTHxHEIGHT such as 10,20,300x200, got '" + text + "'");
}

void add_crop(CLI::App& app, Crop& crop) {
  const auto set = [&crop](const std::string& text) { crop = crop_from(text); };
  app.add_option_function<std::string>("--crop", set,
                                       "Take this part of the image: the column and row of its "
                                       "first pixel, and its size")
      ->type_name("X,Y,WxH");
}

void add_blur(CLI::App& app, double& sigma) {
  add_value(app, "--blur", sigma,
            "Smooth grey levels first, by a Gaussian filter of this standard deviation in "
            "pixels, 0 to 100",
            real_number(0, 100), "SIGMA");
}

}  // namespace

std::vector<std::int64_t> whole_numbers(const std::string& text, const std::string& form,
                                        int max_digits) {
  const std::string number = fmt::format("([0-9]{{1,{}}})", max_digits);
  const std::regex pattern(std::regex_replace(form, std::regex("N"), number));
  std::smatch parts;
  std::vector<std::int64_t> numbers;
  if (!std::regex_match(text, parts, pattern)) return numbers;
  for (std::size_t i = 1; i < parts.size(); ++i) numbers.push_back(std::stoll(parts[i]));
  return numbers;
}

std::optional<std::vector<double>> numbers_from(const std::string& text) {
  std::vector<double> numbers;
  const char* const end = text.data() + text.size();
  for (const char* from = text.data();; ++from) {
    double number = 0;
    const auto read = std::from_chars(from, end, number);
    if (read.ec != std::errc() || !std::isfinite(number)) return {};
    numbers.push_back(number);
    from = read.ptr;
    if (from == end) return numbers;
    if (*from != ',') return {};
  }
}

Pixel pixel_from(const char* name, const std::string& text) {
  const auto numbers = whole_numbers(text, "N,N", 9);
  if (!numbers.empty()) {
    return {static_cast<std::int32_t>(numbers[0]), static_cast<std::int32_t>(numbers[1])};
  }
  throw UsageError(std::string(name) + ": expected X,Y such as 120,45, got '" + text + "'");
}

void add_spacing_option(CLI::App& app, Spacing& spacing) {
  const auto set = [&spacing](const std::string& text) {
    const auto numbers = numbers_from(text).value_or(std::vector<double>());
    const auto is_length = [](double number) { return number >= 1e-30 && number <= 1e30; };
    if (numbers.empty() || numbers.size() > 2 || !std::ranges::all_of(numbers, is_length)) {
      throw UsageError(
          "--spacing: expected one or two numbers from 1e-30 to 1e30, such as 0.5 or 0.5,0.7; got "
          "'" +
          text + "'");
    }
    spacing = {numbers.front(), numbers.back()};
  };
  app.add_option_function<std::string>(
         "--spacing", set,
         "How far columns, and rows, are apart: lengths, widths and distances are in this unit")
      ->type_name("DX[,DY]");
}

Options add_binarise_options(CLI::App& app, BinariseOptions& options, CLI::Option* image) {
  Options all = options_added(app, [&] {
    add_foreground(app, options.foreground);
    add_local(app, options, add_threshold(app, options));
    add_channel(app, options.grey);
    add_background(app, options.grey.backdrop);
    add_blur(app, options.grey.blur);
    add_crop(app, options.grey.crop);
    app.add_flag("--lenient", options.lenient,
                 "Read damaged JPEG and TIFF files as far as possible, with a warning");
  });
  for (CLI::Option* option : all) {
    if (image != nullptr) option->needs(image);
  }
  return all;
}

std::string given_words(const Options& options) {
  std::string words;
  for (const CLI::Option* option : options) {
    if (option->count() == 0) continue;
    words += " --" + option->get_lnames().front();
    const bool is_flag = option->get_expected_max() == 0;
    if (!is_flag) words += " " + option->results().front();
  }
  return words;
}

}  // namespace thinbench
