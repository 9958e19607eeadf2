// The lower envelope of parabolas: column u with vertical distance g is the parabola
// (x - u)^2 + g^2, and the squared distance of pixel x is the lowest value there.
//
// Cost per pixel: one division where a parabola joins the envelope, a comparison where it leaves it
// again, and a square where it is read.
#include "distance/kernels.hpp"
#include "thinbench/distance.hpp"

namespace thinbench::detail {
namespace {

constexpr std::int64_t square(std::int64_t a) {
  return a * a;
}

class Envelope {
 public:
  Envelope(const std::uint16_t* vertical, DistanceRow& memory, Index width)
      : vertical_(vertical), sites_(memory.sites()), starts_(memory.starts()), width_(width) {
    for (Index u = 0; u < width; ++u) {
      if (vertical[u] < kFarVertically) add(u);
    }
  }

  void write(std::int32_t* distances) const {
    for (Index i = 0; i < count_; ++i) {
      const Index end = i + 1 < count_ ? starts_[i + 1] : width_;
      const Index u = sites_[i];
      for (Index x = starts_[i]; x < end; ++x)
        distances[x] = static_cast<std::int32_t>(value(u, x));
    }
    if (count_ > 0) return;
    for (Index x = 0; x < width_; ++x) distances[x] = kNoBackground;
  }

 private:
  [[nodiscard]] std::int64_t value(Index u, Index x) const {
    return square(x - u) + square(vertical_[u]);
  }

  /// The first x where the parabola of v, right of u, is below that of u; not for v below u at 0.
  [[nodiscard]] Index first_below(Index u, Index v) const {
    return (square(v) - square(u) + square(vertical_[v]) - square(vertical_[u])) / (2 * (v - u)) +
           1;
  }

  void add(Index v) {
    while (count_ > 0 &&
           value(sites_[count_ - 1], starts_[count_ - 1]) > value(v, starts_[count_ - 1])) {
      --count_;
    }
    Index start = 0;
    if (count_ > 0) start = first_below(sites_[count_ - 1], v);
    if (start >= width_) return;
    sites_[count_] = static_cast<std::int32_t>(v);
    starts_[count_] = static_cast<std::int32_t>(start);
    ++count_;
  }

  const std::uint16_t* vertical_;
  std::int32_t* sites_;
  std::int32_t* starts_;
  Index width_;
  Index count_ = 0;
};

}  // namespace

void envelope_row(const std::uint16_t* vertical, DistanceRow& memory, std::int32_t* distances,
                  Index width) {
  Envelope(vertical, memory, width).write(distances);
}

}  // namespace thinbench::detail
