#include "images/binarise.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "images/image_file.hpp"
#include "images/mat_of.hpp"
#include "images/packed_file.hpp"

namespace thinbench {
namespace {

constexpr int kLevels = 256;
using Histogram = std::array<double, kLevels>;  // exact: counts are far below 2^53

/// Neighbours, which often have one level, are counted in four tables: an addition need not wait
/// for the one before.
Histogram histogram_of(const ConstImageView& grey) {
  std::array<std::array<std::uint32_t, kLevels>, 4> tables{};
  for (Index y = 0; y < grey.height; ++y) {
    const std::uint8_t* row = grey.row(y);
    Index x = 0;
    for (; x + 4 <= grey.width; x += 4) {
      ++tables[0][row[x]];
      ++tables[1][row[x + 1]];
      ++tables[2][row[x + 2]];
      ++tables[3][row[x + 3]];
    }
    for (; x < grey.width; ++x) ++tables[0][row[x]];
  }
  Histogram counts{};
  for (const auto& table : tables) {
    for (std::size_t level = 0; level < kLevels; ++level) counts[level] += table[level];
  }
  return counts;
}

/// Pixels from one grey level to before another.
struct Class {
  double pixels = 0;
  double sum = 0;
  double sum_of_squares = 0;

  [[nodiscard]] double variance_sum() const {
    return pixels == 0 ? 0 : sum_of_squares - sum * sum / pixels;
  }
};

Class class_of(const Histogram& counts, int first, int end) {
  Class result;
  for (int level = first; level < end; ++level) {
    const double count = counts[static_cast<std::size_t>(level)];
    result.pixels += count;
    result.sum += count * level;
    result.sum_of_squares += count * level * level;
  }
  return result;
}

/// The share of the variance that a limit leaves to the distance of the two means; 0 where there is
/// no variance.
double separation(const Histogram& counts, int threshold) {
  const double all = class_of(counts, 0, kLevels).variance_sum();
  if (all <= 0) return 0;
  const double within = class_of(counts, 0, threshold).variance_sum() +
                        class_of(counts, threshold, kLevels).variance_sum();
  return 1 - within / all;
}

std::optional<int> only_level(const Histogram& counts) {
  const auto is_used = [](double count) { return count > 0; };
  if (std::count_if(counts.begin(), counts.end(), is_used) != 1) return std::nullopt;
  return static_cast<int>(std::find_if(counts.begin(), counts.end(), is_used) - counts.begin());
}

bool is_binary(const Histogram& counts) {
  return std::all_of(counts.begin() + 1, counts.end() - 1, [](double count) { return count == 0; });
}

/// The grey level from which pixels are bright by Otsu's method: the greatest variance between the
/// classes. The same operations in the same order as in OpenCV, so that ties and rounding agree.
int otsu_threshold(const Histogram& counts, double pixels) {
  const double scale = 1 / pixels;
  double mean = 0;
  for (int level = 0; level < kLevels; ++level) {
    mean += level * counts[static_cast<std::size_t>(level)];
  }
  mean *= scale;
  double mean_below = 0, share_below = 0, best = 0;
  int threshold = 0;
  for (int level = 0; level < kLevels; ++level) {
    const double share = counts[static_cast<std::size_t>(level)] * scale;
    mean_below *= share_below;
    share_below += share;
    const double share_above = 1 - share_below;
    constexpr double kTiny = std::numeric_limits<float>::epsilon();
    if (std::min(share_below, share_above) < kTiny) continue;
    if (std::max(share_below, share_above) > 1 - kTiny) continue;
    mean_below = (mean_below + level * share) / share_below;
    const double mean_above = (mean - share_below * mean_below) / share_above;
    const double distance = mean_below - mean_above;
    const double variance = share_below * share_above * distance * distance;
    if (variance <= best) continue;
    best = variance;
    threshold = level;
  }
  return threshold + 1;  // OpenCV takes as bright what is above its threshold
}

/// Makes pixels from this grey level on 255 and all others 0.
void split(ByteImage& grey, int threshold) {
  cv::Mat mat = mat_of(grey.view());
  cv::threshold(mat, mat, threshold - 1, 255, cv::THRESH_BINARY);
}

BrightPixels bright_pixels(const ConstImageView& image) {
  BrightPixels count{foreground_pixels(image), image.width * image.height};
  for (Index y = 0; y < image.height; ++y) {
    const bool whole_row = y == 0 || y == image.height - 1;
    const Index step = whole_row ? 1 : std::max<Index>(1, image.width - 1);
    for (Index x = 0; x < image.width; x += step) {
      ++count.all_on_border;
      count.bright_on_border += image.row(y)[x] != 0 ? 1 : 0;
    }
  }
  return count;
}

/// See BinariseOptions::foreground.
Foreground likely_foreground(const BrightPixels& count) {
  const Index on_border = 2 * count.bright_on_border - count.all_on_border;
  if (on_border != 0) return on_border < 0 ? Foreground::bright : Foreground::dark;
  return 2 * count.bright > count.all ? Foreground::dark : Foreground::bright;
}

Foreground foreground_of(const BrightPixels& count, const BinariseOptions& options) {
  return options.foreground == Foreground::automatic ? likely_foreground(count)
                                                     : options.foreground;
}

double foreground_share(const BrightPixels& count, Foreground foreground) {
  const Index pixels = foreground == Foreground::bright ? count.bright : count.all - count.bright;
  return static_cast<double>(pixels) / static_cast<double>(count.all);
}

/// "foreground is bright (grey level >= 108)".
std::string description(const BinaryImage& binary) {
  const bool is_bright = binary.foreground == Foreground::bright;
  return fmt::format("foreground is {} (grey level {} {})", is_bright ? "bright" : "dark",
                     is_bright ? ">=" : "<", binary.threshold);
}

const char* opposite(const BinaryImage& binary) {
  return binary.foreground == Foreground::bright ? "--foreground dark" : "--foreground bright";
}

std::string note(const BinaryImage& binary, const BinariseOptions& options) {
  const bool is_as_read = binary.was_binary && binary.foreground == Foreground::bright;
  std::vector<const char*> overrides;  // options that choose otherwise what was chosen here
  if (options.foreground == Foreground::automatic) overrides.push_back(opposite(binary));
  if (!options.threshold && !binary.was_binary) overrides.push_back("--threshold N");
  if (is_as_read || binary.only_level || overrides.empty()) return {};
  return fmt::format("{}; {} {} this", description(binary), fmt::join(overrides, " and "),
                     overrides.size() == 1 ? "overrides" : "override");
}

std::string histogram_warning(const BinaryImage& binary, const BinariseOptions& options) {
  if (binary.only_level) {
    return fmt::format(
        "all pixels have the same grey level, {}: {}", *binary.only_level,
        binary.foreground_share > 0 ? "all of them are foreground" : "none is foreground");
  }
  if (options.threshold || binary.separation >= kMinSeparation) return {};
  return fmt::format(
      "the histogram has no two classes ({:.1f} % of the variance lies between them; uniform noise "
      "has 75 %); check the result or choose --threshold N",
      100 * binary.separation);
}

std::string share_warning(const BinaryImage& binary) {
  if (binary.only_level || binary.foreground_share <= 0.5) return {};
  return fmt::format("{:.1f} % of the image is foreground; {} takes the rest instead",
                     100 * binary.foreground_share, opposite(binary));
}

void print_line(const char* kind, const std::string& name, const std::string& text,
                std::ostream& log) {
  if (!text.empty()) log << kind << name << ": " << text << '\n';
}

}  // namespace

BinaryImage binarise(ByteImage grey, const BinariseOptions& options) {
  const Histogram counts = histogram_of(grey.view());
  const auto pixels = static_cast<double>(grey.width() * grey.height());
  const int threshold = options.threshold.value_or(otsu_threshold(counts, pixels));
  split(grey, threshold);
  const BrightPixels count = bright_pixels(grey.view());
  const Foreground foreground = foreground_of(count, options);
  cv::Mat mat = mat_of(grey.view());
  if (foreground == Foreground::dark) cv::bitwise_not(mat, mat);
  return {std::move(grey),
          foreground,
          threshold,
          foreground_share(count, foreground),
          separation(counts, threshold),
          only_level(counts),
          is_binary(counts)};
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
  const Foreground foreground = foreground_of(count, options);
  BinaryImage result{{}, foreground, 1, foreground_share(count, foreground), 1, {}, true};
  if (count.bright == 0) result.only_level = 0;
  if (count.bright == count.all) result.only_level = 255;
  return result;
}

std::vector<std::string> warnings(const BinaryImage& binary, const BinariseOptions& options) {
  std::vector<std::string> texts = {histogram_warning(binary, options), share_warning(binary)};
  std::erase(texts, "");
  return texts;
}

void print_remarks(const std::string& name, const BinaryImage& binary,
                   const BinariseOptions& options, std::ostream& log) {
  print_line("note: ", name, note(binary, options), log);
  for (const std::string& text : warnings(binary, options))
    print_line("warning: ", name, text, log);
}

ByteImage read_grey(const std::string& path, const BinariseOptions& options, std::ostream& log) {
  std::string warning;
  ByteImage grey = read_grey(path, options.lenient ? &warning : nullptr);
  print_line("warning: ", path, warning, log);
  return grey;
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
