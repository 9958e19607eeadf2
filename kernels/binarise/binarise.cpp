#include "thinbench/binarise.hpp"

#include <algorithm>
#include <string>

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

void check(const Binarisation& request) {
  detail::require_enumerator(request.foreground, kForegroundNames.size(), "foreground");
  const auto in = [](int value, int lowest, int highest) {
    return lowest <= value && value <= highest;
  };
  const int threshold = request.threshold.value_or(0);
  require(in(threshold, 0, 255),
          "threshold: expected an integer in [0, 255], got " + std::to_string(threshold));
  if (!request.local) return;
  const auto [window, offset] = *request.local;
  require(!request.threshold, "threshold: expected a level or a local threshold, not both");
  require(window == 0 || (in(window, 3, 65535) && window % 2 == 1),
          "window: expected an odd integer in [3, 65535], got " + std::to_string(window));
  require(in(offset, 0, 255),
          "offset: expected an integer in [0, 255], got " + std::to_string(offset));
}

/// 255 on bright pixels.
void split(const ConstImageView& grey, const ImageView& to, int threshold, Foreground foreground) {
  const int flip = foreground == Foreground::dark ? 255 : 0;
  for (Index y = 0; y < grey.height; ++y) {
    const std::uint8_t* const from = grey.row(y);
    std::uint8_t* const row = to.row(y);
    for (Index x = 0; x < grey.width; ++x) {
      row[x] = static_cast<std::uint8_t>((from[x] >= threshold ? 255 : 0) ^ flip);
    }
  }
}

BrightPixels bright_pixels(const ConstImageView& grey, int threshold,
                           const detail::Histogram& counts) {
  BrightPixels count;
  count.all = grey.width * grey.height;
  for (int level = threshold; level < detail::kLevels; ++level) {
    count.bright += static_cast<Index>(counts[static_cast<std::size_t>(level)]);
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
Foreground deviating_side(const ConstImageView& grey, int window) {
  LocalMeans means(grey, window);
  std::int64_t sum_of_cubes = 0;
  for (Index y = 0; y < grey.height; ++y) {
    means.visit_row(y, [&](Index, Index level, std::int64_t sum, Index pixels) {
      const std::int64_t deviation = (level * pixels - sum) / pixels;
      sum_of_cubes += deviation * deviation * deviation;
    });
  }
  return sum_of_cubes < 0 ? Foreground::dark : Foreground::bright;
}

/// Writes the foreground; returns its number of pixels. The images are different ones.
Index split_by_means(const ConstImageView& grey, const ImageView& to, int window, int offset,
                     Foreground foreground) {
  LocalMeans means(grey, window);
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

void binarise_locally(const ConstImageView& grey, const ImageView& destination,
                      const Binarisation& request, Binarised& result) {
  result.window = detail::window_of(*request.local, grey.width, grey.height);
  result.foreground = request.foreground == Foreground::automatic
                          ? deviating_side(grey, result.window)
                          : request.foreground;
  const detail::ByteImage copy =
      grey.data == destination.data ? detail::copy_of(grey) : detail::ByteImage();
  const ConstImageView from = copy.width() > 0 ? copy.view() : grey;
  const Index found =
      split_by_means(from, destination, result.window, request.local->offset, result.foreground);
  result.foreground_share =
      static_cast<double>(found) / static_cast<double>(grey.width * grey.height);
}

}  // namespace

Binarised binarise(ConstImageView grey, ImageView destination, const Binarisation& request,
                   const Execution& execution) {
  detail::check_views(grey, destination, detail::InPlace::allowed);
  check(request);
  detail::require_execution(execution);
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
    binarise_locally(grey, destination, request, result);
    return result;
  }
  const BrightPixels count = bright_pixels(grey, threshold, counts);
  result.foreground = detail::foreground_of(count, request.foreground);
  result.foreground_share = detail::foreground_share(count, result.foreground);
  split(grey, destination, threshold, result.foreground);
  return result;
}

}  // namespace thinbench
