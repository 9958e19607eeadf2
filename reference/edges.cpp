#include <algorithm>
#include <cstdlib>

#include "reference.hpp"

namespace thinbench::reference {
namespace {

/// A grey image with edge replication.
struct GreyImage {
  ConstImageView view;

  [[nodiscard]] int at(Index x, Index y) const {
    return view.row(
        std::clamp<Index>(y, 0, view.height - 1))[std::clamp<Index>(x, 0, view.width - 1)];
  }
};

struct Gradient {
  int gx;
  int gy;
};

Gradient roberts4(const GreyImage& f, Index x, Index y) {
  return {f.at(x, y) - f.at(x + 1, y + 1), f.at(x + 1, y) - f.at(x, y + 1)};
}

Gradient roberts9(const GreyImage& f, Index x, Index y) {
  return {f.at(x - 1, y - 1) - f.at(x + 1, y + 1), f.at(x + 1, y - 1) - f.at(x - 1, y + 1)};
}

/// Columns and rows of the window weighted 1, `middle`, 1: Prewitt with 1, Sobel with 2.
Gradient weighted(const GreyImage& f, Index x, Index y, int middle) {
  const auto column = [&](Index at) {
    return f.at(at, y - 1) + middle * f.at(at, y) + f.at(at, y + 1);
  };
  const auto row = [&](Index at) {
    return f.at(x - 1, at) + middle * f.at(x, at) + f.at(x + 1, at);
  };
  return {column(x + 1) - column(x - 1), row(y + 1) - row(y - 1)};
}

Gradient prewitt(const GreyImage& f, Index x, Index y) {
  return weighted(f, x, y, 1);
}

Gradient sobel(const GreyImage& f, Index x, Index y) {
  return weighted(f, x, y, 2);
}

int sign(Index value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// The window split by its two diagonals.
template <int reach>
Gradient mero_vassy(const GreyImage& f, Index x, Index y) {
  Gradient split = {0, 0};
  for (Index up = -reach; up <= reach; ++up) {
    for (Index right = -reach; right <= reach; ++right) {
      const int grey = f.at(x + right, y - up);
      split.gx += grey * sign(right + up);
      split.gy += grey * sign(right - up);
    }
  }
  return split;
}

int brightest_neighbour(const GreyImage& f, Index x, Index y) {
  int brightest = 0;
  for (Index row = y - 1; row <= y + 1; ++row) {
    for (Index column = x - 1; column <= x + 1; ++column) {
      brightest = std::max(brightest, f.at(column, row));
    }
  }
  return brightest;
}

template <Gradient (*gradient)(const GreyImage& f, Index x, Index y), int scale>
void edges_by(const EdgeThresholds& thresholds, ConstImageView source, ImageView destination) {
  const auto [gradient_threshold, brightness_threshold] = thresholds;
  const GreyImage image = {source};
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) {
      const Gradient at = gradient(image, x, y);
      const int magnitude = std::abs(at.gx) + std::abs(at.gy);
      const bool edge = magnitude > gradient_threshold * scale &&
                        brightest_neighbour(image, x, y) > brightness_threshold;
      destination.row(y)[x] = edge ? 255 : 0;
    }
  }
}

}  // namespace

EdgeDetection edges(EdgeOperator op) {
  switch (op) {
    case EdgeOperator::roberts4:
      return &edges_by<&roberts4, 2>;
    case EdgeOperator::roberts9:
      return &edges_by<&roberts9, 2>;
    case EdgeOperator::mero_vassy:
      return &edges_by<&mero_vassy<1>, 4>;
    case EdgeOperator::mero_vassy_5x5:
      return &edges_by<&mero_vassy<2>, 12>;
    case EdgeOperator::sobel:
      return &edges_by<&sobel, 4>;
    case EdgeOperator::prewitt:
      break;
  }
  return &edges_by<&prewitt, 3>;
}

}  // namespace thinbench::reference
