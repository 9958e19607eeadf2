#include <algorithm>
#include <cstdlib>

#include "reference.hpp"

namespace thinbench::reference {
namespace {

/// A grey picture that continues beyond its frame with its outermost pixels.
struct Picture {
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

Gradient roberts4(const Picture& f, Index x, Index y) {
  return {f.at(x, y) - f.at(x + 1, y + 1), f.at(x + 1, y) - f.at(x, y + 1)};
}

Gradient roberts9(const Picture& f, Index x, Index y) {
  return {f.at(x - 1, y - 1) - f.at(x + 1, y + 1), f.at(x + 1, y - 1) - f.at(x - 1, y + 1)};
}

/// Columns and rows of the window weighed 1, `middle`, 1: Prewitt with 1, Sobel with 2.
Gradient weighed(const Picture& f, Index x, Index y, int middle) {
  const auto column = [&](Index at) {
    return f.at(at, y - 1) + middle * f.at(at, y) + f.at(at, y + 1);
  };
  const auto row = [&](Index at) {
    return f.at(x - 1, at) + middle * f.at(x, at) + f.at(x + 1, at);
  };
  return {column(x + 1) - column(x - 1), row(y + 1) - row(y - 1)};
}

Gradient prewitt(const Picture& f, Index x, Index y) {
  return weighed(f, x, y, 1);
}

Gradient sobel(const Picture& f, Index x, Index y) {
  return weighed(f, x, y, 2);
}

int sign(Index value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// The window split by its two diagonals, `up` pointing up.
template <int reach>
Gradient mero_vassy(const Picture& f, Index x, Index y) {
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

int brightest_neighbour(const Picture& f, Index x, Index y) {
  int brightest = 0;
  for (Index row = y - 1; row <= y + 1; ++row) {
    for (Index column = x - 1; column <= x + 1; ++column) {
      brightest = std::max(brightest, f.at(column, row));
    }
  }
  return brightest;
}

struct Operator {
  std::string_view operation;
  Gradient (*gradient)(const Picture& f, Index x, Index y);
  int scale;
};

constexpr Operator kOperators[] = {
    {"edges_roberts4", &roberts4, 2},
    {"edges_roberts9", &roberts9, 2},
    {"edges_mero_vassy", &mero_vassy<1>, 4},
    {"edges_mero_vassy_5x5", &mero_vassy<2>, 12},
    {"edges_sobel", &sobel, 4},
    {"edges_prewitt", &prewitt, 3},
};

template <std::size_t which>
void edges(int p1, int p2, ConstImageView source, ImageView destination) {
  constexpr Operator op = kOperators[which];
  const Picture picture = {source};
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) {
      const Gradient gradient = op.gradient(picture, x, y);
      const int magnitude = std::abs(gradient.gx) + std::abs(gradient.gy);
      const bool edge = magnitude > p1 * op.scale && brightest_neighbour(picture, x, y) > p2;
      destination.row(y)[x] = edge ? 255 : 0;
    }
  }
}

constexpr EdgeDetection kDetections[] = {&edges<0>, &edges<1>, &edges<2>,
                                         &edges<3>, &edges<4>, &edges<5>};

}  // namespace

EdgeDetection find_edges(std::string_view operation) {
  for (std::size_t i = 0; i < std::size(kOperators); ++i) {
    if (kOperators[i].operation == operation) return kDetections[i];
  }
  return nullptr;
}

}  // namespace thinbench::reference
