// The lower envelope of parabolas: column u with vertical distance g is the parabola
// (x - u)^2 + g^2, and the squared distance of pixel x is the lowest value there.
//
// Cost per pixel: one division where a parabola joins the envelope, a comparison where it leaves it
// again, and a square where it is read.
#include <algorithm>
#include <cmath>
#include <limits>

#include "distance/kernels.hpp"
#include "thinbench/distance.hpp"

namespace thinbench::detail {
namespace {

template <class T>
constexpr T square(T a) {
  return a * a;
}

/// In whole numbers.
struct SquarePixels {
  const std::uint16_t* vertical;

  [[nodiscard]] std::int64_t value(Index u, Index x) const {
    return square(x - u) + square<std::int64_t>(vertical[u]);
  }

  /// The first x where the parabola of v, right of u, is below that of u; not for v below u at 0.
  [[nodiscard]] Index first_below(Index u, Index v) const {
    return (value(v, 0) - value(u, 0)) / (2 * (v - u)) + 1;
  }
};

/// In units of the spacing.
struct SpacedPixels {
  const std::uint16_t* vertical;
  Spacing spacing;
  Index width;

  [[nodiscard]] double value(Index u, Index x) const {
    return square(vertical[u] * spacing.y) + square(static_cast<double>(x - u) * spacing.x);
  }

  /// Corrects the quotient, which is rounded, by values.
  [[nodiscard]] Index first_below(Index u, Index v) const {
    const double quotient =
        (value(v, 0) - value(u, 0)) / (2 * static_cast<double>(v - u) * square(spacing.x));
    const auto end = static_cast<double>(width);
    auto x = static_cast<Index>(std::clamp(std::floor(quotient) + 1, 0.0, end));
    while (x > 0 && value(v, x - 1) < value(u, x - 1)) --x;
    while (x < width && value(v, x) >= value(u, x)) ++x;
    return x;
  }
};

template <class Pixels>
class Envelope {
 public:
  Envelope(const Pixels& pixels, DistanceRow& memory, Index width)
      : pixels_(pixels), sites_(memory.sites()), starts_(memory.starts()), width_(width) {
    for (Index u = 0; u < width; ++u) {
      if (pixels.vertical[u] < kFarVertically) add(u);
    }
  }

  /// Calls `body(x, lowest value)`, unless there is no parabola.
  template <class Body>
  bool for_values(const Body& body) const {
    for (Index i = 0; i < count_; ++i) {
      const Index end = i + 1 < count_ ? starts_[i + 1] : width_;
      const Index u = sites_[i];
      for (Index x = starts_[i]; x < end; ++x) body(x, pixels_.value(u, x));
    }
    return count_ > 0;
  }

 private:
  void add(Index v) {
    while (count_ > 0 && pixels_.value(sites_[count_ - 1], starts_[count_ - 1]) >
                             pixels_.value(v, starts_[count_ - 1])) {
      --count_;
    }
    Index start = 0;
    if (count_ > 0) start = pixels_.first_below(sites_[count_ - 1], v);
    if (start >= width_) return;
    sites_[count_] = static_cast<std::int32_t>(v);
    starts_[count_] = static_cast<std::int32_t>(start);
    ++count_;
  }

  Pixels pixels_;
  std::int32_t* sites_;
  std::int32_t* starts_;
  Index width_;
  Index count_ = 0;
};

}  // namespace

void envelope_row(const std::uint16_t* vertical, DistanceRow& memory, std::int32_t* distances,
                  Index width) {
  const Envelope<SquarePixels> envelope({vertical}, memory, width);
  const bool is_found = envelope.for_values(
      [&](Index x, std::int64_t value) { distances[x] = static_cast<std::int32_t>(value); });
  if (!is_found) std::fill_n(distances, width, kNoBackground);
}

void spaced_row(const std::uint16_t* vertical, DistanceRow& memory, const Spacing& spacing,
                double* distances, Index width) {
  const Envelope<SpacedPixels> envelope({vertical, spacing, width}, memory, width);
  const bool is_found =
      envelope.for_values([&](Index x, double value) { distances[x] = std::sqrt(value); });
  if (!is_found) std::fill_n(distances, width, std::numeric_limits<double>::infinity());
}

}  // namespace thinbench::detail
