#include "images/binarise.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "images/image_file.hpp"
#include "images/mat_of.hpp"
#include "images/packed_file.hpp"
#include "support/text.hpp"

namespace thinbench {
namespace {

const char* opposite(const BinaryImage& binary) {
  return binary.foreground == Foreground::bright ? "--foreground dark" : "--foreground bright";
}

std::string note(const BinaryImage& binary, const BinariseOptions& options) {
  const bool is_as_read = binary.was_binary && binary.foreground == Foreground::bright;
  std::vector<const char*> overrides;  // options that choose otherwise what was chosen here
  if (options.foreground == Foreground::automatic) overrides.push_back(opposite(binary));
  if (!options.threshold && !options.local && !binary.was_binary)
    overrides.push_back("--threshold N");
  if (is_as_read || binary.only_level || overrides.empty()) return {};
  return fmt::format("foreground is {}; {} {} this", class_text(binary),
                     fmt::join(overrides, " and "),
                     overrides.size() == 1 ? "overrides" : "override");
}

std::string histogram_warning(const BinaryImage& binary, const BinariseOptions& options) {
  if (binary.only_level) {
    return fmt::format(
        "all pixels have the same grey level, {}: {}", *binary.only_level,
        binary.foreground_share > 0 ? "all of them are foreground" : "none is foreground");
  }
  const bool is_clear =
      binary.separation >= kMinSeparation || binary.undecided_share <= kMaxUndecided;
  if (options.threshold || options.local || is_clear) return {};
  return fmt::format(
      "the two classes overlap: {:.1f} % of the pixels are near the threshold; check the result, "
      "or "
      "try --threshold local, --channel auto, --blur 1 or --threshold N",
      100 * binary.undecided_share);
}

std::string share_warning(const BinaryImage& binary, const BinariseOptions& options) {
  const bool is_usual = binary.foreground_share <= 0.5 || options.is_mostly_foreground;
  if (binary.only_level || is_usual) return {};
  return fmt::format("{:.1f} % of the image is foreground; {} takes the rest instead",
                     100 * binary.foreground_share, opposite(binary));
}

void print_line(const char* kind, const std::string& name, const std::string& text,
                std::ostream& log) {
  if (!text.empty()) log << kind << one_line(name) << ": " << text << '\n';
}

}  // namespace

BinaryImage binarise(ByteImage grey, const BinariseOptions& options) {
  const Binarised found =
      binarise(grey.view(), grey.view(), {options.foreground, options.threshold, options.local});
  return {found, std::move(grey)};
}

void add_rows(BrightPixels& count, const ConstPackedView& rows, Index y, Index height) {
  count.bright += packed_foreground(rows);
  count.all += rows.width * rows.height;
  for (Index i = 0; i < rows.height; ++i) {
    const bool whole_row = y + i == 0 || y + i == height - 1;
    const std::uint8_t* const row = rows.row(i);
    const auto pixel = [&](Index x) { return row[x / 8] >> (7 - x % 8) & 1; };
    count.all_on_border += whole_row ? rows.width : std::min<Index>(rows.width, 2);
    count.bright_on_border += whole_row ? packed_foreground({row, rows.width, 1, rows.order})
                                        : pixel(0) + (rows.width > 1 ? pixel(rows.width - 1) : 0);
  }
}

BinaryImage binarise_packed(const BrightPixels& count, const BinariseOptions& options) {
  BinaryImage result;
  result.foreground = detail::foreground_of(count, options.foreground);
  result.threshold = 1;
  result.foreground_share = detail::foreground_share(count, result.foreground);
  result.separation = 1;
  result.was_binary = true;
  if (count.bright == 0) result.only_level = 0;
  if (count.bright == count.all) result.only_level = 255;
  return result;
}

std::string class_text(const BinaryImage& binary) {
  const std::string_view name = foreground_name(binary.foreground);
  if (binary.window > 0) {
    return fmt::format("{} (by the means of {} x {} pixels)", name, binary.window, binary.window);
  }
  const char* const relation = binary.foreground == Foreground::bright ? ">=" : "<";
  return fmt::format("{} (grey level {} {})", name, relation, binary.threshold);
}

std::vector<std::string> warnings(const BinaryImage& binary, const BinariseOptions& options) {
  std::vector<std::string> texts = {histogram_warning(binary, options),
                                    share_warning(binary, options)};
  std::erase(texts, "");
  return texts;
}

void print_remarks(const std::string& name, const BinaryImage& binary,
                   const BinariseOptions& options, std::ostream& log) {
  print_line("note: ", name, note(binary, options), log);
  for (const std::string& text : warnings(binary, options))
    print_line("warning: ", name, text, log);
}

namespace {

ByteImage cropped(const std::string& path, const ByteImage& image, const Crop& crop) {
  if (crop.x + crop.width > image.width() || crop.y + crop.height > image.height()) {
    throw FileError(fmt::format("{}: --crop {},{},{}x{} is not inside the image of {} x {} pixels",
                                path, crop.x, crop.y, crop.width, crop.height, image.width(),
                                image.height()));
  }
  const ConstImageView all = image.view();
  return copy_of({all.row(crop.y) + crop.x, crop.width, crop.height, all.stride});
}

void blur(ByteImage& image, double sigma) {
  cv::Mat mat = mat_of(image.view());
  cv::GaussianBlur(mat, mat, {}, sigma, sigma, cv::BORDER_REPLICATE);
}

}  // namespace

GreyFile read_grey_file(const std::string& path, std::optional<int> page,
                        const BinariseOptions& options) {
  GreyFile file = {{}, options.channel, {}};
  file.grey = read_channel(path, page, file.channel, options.lenient ? &file.warning : nullptr);
  if (is_transparent(path)) {
    file.warning += file.warning.empty() ? "" : "; ";
    file.warning +=
        "the image is transparent in places; the colours stored there count as if it were opaque";
  }
  if (options.crop.height > 0) file.grey = cropped(path, file.grey, options.crop);
  if (options.blur > 0) blur(file.grey, options.blur);
  return file;
}

ByteImage read_grey(const std::string& path, const BinariseOptions& options, std::ostream& log) {
  GreyFile file = read_grey_file(path, std::nullopt, options);
  print_line("warning: ", path, file.warning, log);
  if (options.channel == Channel::automatic) {
    const std::string_view name = channel_name(file.channel);
    print_line("note: ", path, fmt::format("channel is {}; --channel overrides this", name), log);
  }
  return std::move(file.grey);
}

ByteImage read_binary(const std::string& path, const BinariseOptions& options, std::ostream* log) {
  std::ostringstream ignored;
  BinaryImage binary = binarise(read_grey(path, options, log != nullptr ? *log : ignored), options);
  if (log != nullptr) print_remarks(path, binary, options, *log);
  return std::move(binary.image);
}

Index foreground_pixels(ConstImageView image) {
  constexpr Index kRows = 64;  // at a time: OpenCV counts up to 2^31 - 1
  Index count = 0;
  for (Index y = 0; y < image.height && image.width > 0; y += kRows) {
    const Index rows = std::min(kRows, image.height - y);
    count += cv::countNonZero(mat_of({image.row(y), image.width, rows, image.stride}));
  }
  return count;
}

}  // namespace thinbench
