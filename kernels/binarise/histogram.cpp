#include "binarise/histogram.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace thinbench::detail {
namespace {

/// Pixels from one grey level to before another.
struct Class {
  double pixels = 0;
  double sum = 0;
  double sum_of_squares = 0;

  [[nodiscard]] double variance_sum() const {
    return pixels == 0 ? 0 : sum_of_squares - sum * sum / pixels;
  }
};

int levels_of(const Histogram& counts) {
  return static_cast<int>(counts.size());
}

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

}  // namespace

/// Neighbours, which often have one level, are counted in four tables: an addition need not wait
/// for the one before.
template <class T>
Histogram histogram_of(const View<const T>& grey) {
  constexpr std::size_t levels = std::size_t{std::numeric_limits<T>::max()} + 1;
  std::vector<std::uint64_t> tables(4 * levels);
  for (Index y = 0; y < grey.height; ++y) {
    const T* row = grey.row(y);
    Index x = 0;
    for (; x + 4 <= grey.width; x += 4) {
      ++tables[row[x]];
      ++tables[levels + row[x + 1]];
      ++tables[2 * levels + row[x + 2]];
      ++tables[3 * levels + row[x + 3]];
    }
    for (; x < grey.width; ++x) ++tables[row[x]];
  }
  Histogram counts(levels);
  for (std::size_t i = 0; i < tables.size(); ++i) {
    counts[i % levels] += static_cast<double>(tables[i]);
  }
  return counts;
}

template Histogram histogram_of(const ConstImageView& grey);
template Histogram histogram_of(const View<const std::uint16_t>& grey);

double separation(const Histogram& counts, int threshold) {
  const double all = class_of(counts, 0, levels_of(counts)).variance_sum();
  if (all <= 0) return 0;
  const double within = class_of(counts, 0, threshold).variance_sum() +
                        class_of(counts, threshold, levels_of(counts)).variance_sum();
  return 1 - within / all;
}

double undecided_share(const Histogram& counts, int threshold) {
  const Class dark = class_of(counts, 0, threshold);
  const Class bright = class_of(counts, threshold, levels_of(counts));
  if (dark.pixels == 0 || bright.pixels == 0) return 0;
  const double near = 0.1 * (bright.sum / bright.pixels - dark.sum / dark.pixels);
  double pixels = 0;
  for (int level = 0; level < levels_of(counts); ++level) {
    if (std::abs(level - (threshold - 0.5)) < near) {
      pixels += counts[static_cast<std::size_t>(level)];
    }
  }
  return pixels / (dark.pixels + bright.pixels);
}

std::optional<int> only_level(const Histogram& counts) {
  const auto is_used = [](double count) { return count > 0; };
  if (std::count_if(counts.begin(), counts.end(), is_used) != 1) return std::nullopt;
  return static_cast<int>(std::find_if(counts.begin(), counts.end(), is_used) - counts.begin());
}

bool is_binary(const Histogram& counts) {
  return std::all_of(counts.begin() + 1, counts.end() - 1, [](double count) { return count == 0; });
}

int otsu_threshold(const Histogram& counts) {
  const double scale = 1 / std::accumulate(counts.begin(), counts.end(), 0.0);
  double mean = 0;
  for (int level = 0; level < levels_of(counts); ++level) {
    mean += level * counts[static_cast<std::size_t>(level)];
  }
  mean *= scale;
  double mean_below = 0, share_below = 0, best = 0;
  int threshold = 0;
  for (int level = 0; level < levels_of(counts); ++level) {
    const double share = counts[static_cast<std::size_t>(level)] * scale;
    mean_below *= share_below;
    share_below += share;
    const double share_above = 1 - share_below;
    constexpr double kTiny = std::numeric_limits<float>::epsilon();
    if (std::min(share_below, share_above) < kTiny) continue;
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

}  // namespace thinbench::detail
