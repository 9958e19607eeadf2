#include "thinbench/binarise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include "binarise/bright_pixels.hpp"
#include "binarise/histogram.hpp"
#include "binarise/local_means.hpp"
#include "core/byte_image.hpp"
#include "core/checks.hpp"
#include "core/variant.hpp"

namespace thinbench {
namespace {

using detail::BrightPixels;
using detail::LocalMeans;
using detail::require;

/// `highest`: of all grey levels.
void check(const Binarisation& request, int highest) {
  detail::require_enumerator(request.foreground, kForegroundNames.size(), "foreground");
  const auto in = [](int value, int least, int most) { return least <= value && value <= most; };
  const int threshold = request.threshold.value_or(0);
  const std::string levels = "expected an integer in [0, " + std::to_string(highest) + "], got ";
  require(in(threshold, 0, highest), "threshold: " + levels + std::to_string(threshold));
  if (!request.local) return;
  const auto [window, offset] = *request.local;
  require(!request.threshold, "threshold: expected a level or a local threshold, not both");
  require(window == 0 || (in(window, 3, 65535) && window % 2 == 1),
          "window: expected an odd integer in [3, 65535], got " + std::to_string(window));
  require(in(offset.value_or(0), 0, highest),
          "offset: " + levels + std::to_string(offset.value_or(0)));
}

template <class T>
void check(const View<const T>& grey, const ImageView& destination, detail::InPlace in_place) {
  detail::check(detail::memory_of("grey", grey), detail::memory_of("destination", destination),
                in_place);
}

/// 255 on bright pixels.
template <class T>
void split(const View<const T>& grey, const ImageView& to, int threshold, Foreground foreground) {
  const int flip = foreground == Foreground::dark ? 255 : 0;
  for (Index y = 0; y < grey.height; ++y) {
    const T* const from = grey.row(y);
    std::uint8_t* const row = to.row(y);
    for (Index x = 0; x < grey.width; ++x) {
      row[x] = static_cast<std::uint8_t>((from[x] >= threshold ? 255 : 0) ^ flip);
    }
  }
}

template <class T>
BrightPixels bright_pixels(const View<const T>& grey, int threshold,
                           const detail::Histogram& counts) {
  BrightPixels count;
  count.all = grey.width * grey.height;
  for (auto level = static_cast<std::size_t>(threshold); level < counts.size(); ++level) {
    count.bright += static_cast<Index>(counts[level]);
  }
  for (Index y = 0; y < grey.height; ++y) {
    const bool whole_row = y == 0 || y == grey.height - 1;
    const Index step = whole_row ? 1 : std::max<Index>(1, grey.width - 1);
    for (Index x = 0; x < grey.width; x += step) {
      ++count.all_on_border;
      count.bright_on_border += grey.row(y)[x] >= threshold ? 1 : 0;
    }
  }
  return count;
}

/// The side to which pixels deviate farther from their means, by the sum of cubes.
template <class T>
Foreground deviating_side(const View<const T>& grey, int window) {
  LocalMeans<T> means(grey, window);
  std::conditional_t<sizeof(T) == 1, std::int64_t, double> sum_of_cubes = 0;
  for (Index y = 0; y < grey.height; ++y) {
    means.visit_row(y, [&](Index, Index level, std::int64_t sum, Index pixels) {
      const std::int64_t deviation = (level * pixels - sum) / pixels;
      sum_of_cubes += static_cast<decltype(sum_of_cubes)>(deviation * deviation * deviation);
    });
  }
  return sum_of_cubes < 0 ? Foreground::dark : Foreground::bright;
}

/// Writes the foreground; returns its number of pixels. The images are different ones.
template <class T>
Index split_by_means(const View<const T>& grey, const ImageView& to, int window, int offset,
                     Foreground foreground) {
  LocalMeans<T> means(grey, window);
  const int sign = foreground == Foreground::dark ? -1 : 1;
  Index found = 0;
  for (Index y = 0; y < grey.height; ++y) {
    std::uint8_t* const row = to.row(y);
    means.visit_row(y, [&](Index x, Index level, std::int64_t sum, Index pixels) {
      const bool is_foreground = sign * (level * pixels - sum) > offset * pixels;
      row[x] = is_foreground ? 255 : 0;
      found += is_foreground ? 1 : 0;
    });
  }
  return found;
}

template <class T>
int offset_of(const LocalThreshold& local, const detail::Histogram& counts) {
  if (local.offset) return *local.offset;
  if (sizeof(T) == 1) return 10;
  const auto is_used = [](double count) { return count > 0; };
  const auto lowest = std::find_if(counts.begin(), counts.end(), is_used);
  const auto highest = std::find_if(counts.rbegin(), counts.rend(), is_used).base() - 1;
  return static_cast<int>(std::lround(10.0 * static_cast<double>(highest - lowest) / 255.0));
}

template <class T>
void binarise_locally(const View<const T>& grey, const ImageView& destination,
                      const Binarisation& request, int offset, Binarised& result) {
  result.window = detail::window_of(*request.local, grey.width, grey.height);
  result.foreground = request.foreground == Foreground::automatic
                          ? deviating_side(grey, result.window)
                          : request.foreground;
  const Index found = split_by_means(grey, destination, result.window, offset, result.foreground);
  result.foreground_share =
      static_cast<double>(found) / static_cast<double>(grey.width * grey.height);
}

template <class T>
Binarised binarise_checked(const View<const T>& grey, const ImageView& destination,
                           const Binarisation& request) {
  check(request, std::numeric_limits<T>::max());
  Binarised result;
  result.threshold = request.threshold.value_or(1);
  if (request.foreground == Foreground::dark) result.foreground = Foreground::dark;
  if (grey.width == 0 || grey.height == 0) return result;
  const detail::Histogram counts = detail::histogram_of(grey);
  const int threshold = request.threshold ? *request.threshold : detail::otsu_threshold(counts);
  result.threshold = threshold;
  result.separation = detail::separation(counts, threshold);
  result.undecided_share = detail::undecided_share(counts, threshold);
  result.only_level = detail::only_level(counts);
  result.was_binary = detail::is_binary(counts);
  if (request.local) {
    binarise_locally(grey, destination, request, offset_of<T>(*request.local, counts), result);
    return result;
  }
  const BrightPixels count = bright_pixels(grey, threshold, counts);
  result.foreground = detail::foreground_of(count, request.foreground);
  result.foreground_share = detail::foreground_share(count, result.foreground);
  split(grey, destination, threshold, result.foreground);
  return result;
}

}  // namespace

Binarised binarise(ConstImageView grey, ImageView destination, const Binarisation& request,
                   const Execution& execution) {
  check(grey, destination, detail::InPlace::allowed);
  detail::require_execution(execution);
  if (!request.local || grey.data != destination.data) {
    return binarise_checked(grey, destination, request);
  }
  const detail::ByteImage copy = detail::copy_of(grey);  // windows read what is written
  return binarise_checked(copy.view(), destination, request);
}

Binarised binarise16(View<const std::uint16_t> grey, ImageView destination,
                     const Binarisation& request, const Execution& execution) {
  check(grey, destination, detail::InPlace::rejected);
  detail::require_execution(execution);
  return binarise_checked(grey, destination, request);
}

}  // namespace thinbench
