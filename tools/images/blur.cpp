#include "images/blur.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace thinbench {
namespace {

/// Whole numbers that add up to 2^bits and are as near to the shares of a Gaussian as their
/// rounding errors, passed on inwards, allow.
std::vector<std::uint64_t> kernel_of(double sigma, double sigmas, int bits) {
  const int size = static_cast<int>(std::lrint(sigma * sigmas * 2 + 1)) | 1, half = size / 2;
  std::vector<double> shares(static_cast<std::size_t>(half) + 1);  // from the end to the middle
  for (int i = 0; i <= half; ++i) {
    const double x = i - half;
    shares[static_cast<std::size_t>(i)] = std::exp(-x * x / (2 * sigma * sigma));
  }
  const double sum = 2 * std::accumulate(shares.begin(), shares.end() - 1, 0.0) + shares.back();
  const double one = std::ldexp(1.0, bits);
  std::vector<std::uint64_t> kernel(static_cast<std::size_t>(size));
  double error = 0;
  std::uint64_t used = 0;
  for (std::size_t i = 0; i < shares.size() - 1; ++i) {
    const double wanted = shares[i] / sum * one + error;
    const double taken = std::nearbyint(wanted);
    error = wanted - taken;
    kernel[i] = kernel[kernel.size() - 1 - i] = static_cast<std::uint64_t>(taken);
    used += 2 * kernel[i];
  }
  kernel[shares.size() - 1] = static_cast<std::uint64_t>(one) - used;
  return kernel;
}

template <class T>
void blur_by(const Pixels& image, const std::vector<std::uint64_t>& kernel, int bits) {
  const auto half = static_cast<Index>(kernel.size() / 2);
  const Index width = image.width, height = image.height;
  // Rows of sums along x, as many as the kernel is high; row y has the place y modulo that.
  const auto rows = static_cast<Index>(kernel.size());
  std::vector<std::uint32_t> sums(static_cast<std::size_t>(rows * width));
  std::vector<T> padded(static_cast<std::size_t>(width + 2 * half));
  const auto sums_of = [&](Index y) { return sums.data() + y % rows * width; };
  const auto add_row = [&](Index y) {
    const T* const from = image.samples_of_row<T>(y);
    std::fill_n(padded.begin(), half, from[0]);
    std::copy_n(from, width, padded.begin() + half);
    std::fill_n(padded.begin() + half + width, half, from[width - 1]);
    std::uint32_t* const to = sums_of(y);
    std::fill_n(to, width, 0U);
    for (Index k = 0; k < rows; ++k) {
      const auto weight = static_cast<std::uint32_t>(kernel[static_cast<std::size_t>(k)]);
      for (Index x = 0; x < width; ++x) to[x] += weight * padded[static_cast<std::size_t>(x + k)];
    }
  };
  std::vector<std::uint64_t> column(static_cast<std::size_t>(width));
  for (Index y = 0; y < std::min(half, height); ++y) add_row(y);
  for (Index y = 0; y < height; ++y) {
    if (y + half < height) add_row(y + half);
    std::fill(column.begin(), column.end(), std::uint64_t{1} << (2 * bits - 1));
    for (Index k = 0; k < rows; ++k) {
      const std::uint32_t* const from = sums_of(std::clamp<Index>(y + k - half, 0, height - 1));
      for (Index x = 0; x < width; ++x) {
        column[static_cast<std::size_t>(x)] += kernel[static_cast<std::size_t>(k)] * from[x];
      }
    }
    T* const to = image.samples_of_row<T>(y);
    for (Index x = 0; x < width; ++x) {
      to[x] = static_cast<T>(column[static_cast<std::size_t>(x)] >> 2 * bits);
    }
  }
}

}  // namespace

void blur(const Pixels& image, double sigma) {
  constexpr int bits = 8, deep_bits = 16;  // of fractions
  if (image.kind == SampleKind::u8)
    return blur_by<std::uint8_t>(image, kernel_of(sigma, 3, bits), bits);
  blur_by<std::uint16_t>(image, kernel_of(sigma, 4, deep_bits), deep_bits);
}

}  // namespace thinbench
