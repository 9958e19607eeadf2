#include <algorithm>
#include <array>
#include <stdexcept>

#include "holes.hpp"

namespace thinbench::reference {
namespace {

constexpr std::uint8_t kPoint = 255;

/// The grey levels during the scan, with a background margin.
class Levels {
 public:
  explicit Levels(const ConstImageView& contours)
      : width_(contours.width),
        height_(contours.height),
        levels_(static_cast<std::size_t>((width_ + 2) * (height_ + 2)), 0) {
    for (Index y = 0; y < height_; ++y) {
      for (Index x = 0; x < width_; ++x) at(x, y) = contours.row(y)[x] == kPoint ? kPoint : 0;
    }
  }

  [[nodiscard]] std::uint8_t& at(Index x, Index y) {
    return levels_[static_cast<std::size_t>((y + 1) * (width_ + 2) + x + 1)];
  }

  /// Step d) for one level: rescans from row `first` on.
  void replace(int x, int by, Index first) {
    for (Index row = first; row < height_; ++row) {
      for (Index column = 0; column < width_; ++column) {
        std::uint8_t& level = at(column, row);
        if (level == x) {
          level = static_cast<std::uint8_t>(by);
        } else if (level != 0 && level < x) {
          ++level;
        }
      }
    }
  }

 private:
  Index width_;
  Index height_;
  std::vector<std::uint8_t> levels_;
};

class Scan {
 public:
  explicit Scan(const ConstImageView& contours) : levels_(contours) {}

  /// Steps a) to d) for the point (x, y).
  void visit(Index x, Index y) {
    if (first_row_ < 0) {
      first_row_ = y;
      flag_ = 254;
      levels_.at(x, y) = 254;
      return;
    }
    const auto neighbours = [&] {
      return std::array<int, 4>{levels_.at(x - 1, y), levels_.at(x - 1, y - 1),
                                levels_.at(x, y - 1), levels_.at(x + 1, y - 1)};
    };
    const std::array<int, 4> abcd = neighbours();
    const int maximum = *std::max_element(abcd.begin(), abcd.end());
    levels_.at(x, y) = static_cast<std::uint8_t>(maximum == 0 ? next_level() : maximum);
    // A replacement increments smaller levels, so each neighbour is read again.
    for (std::size_t i = 0; i < abcd.size(); ++i) {
      const int level = neighbours()[i];
      if (level == 0 || level >= maximum) continue;
      levels_.replace(level, maximum, first_row_);
      ++flag_;
    }
  }

  [[nodiscard]] Levels& levels() { return levels_; }
  [[nodiscard]] int flag() const { return flag_; }

 private:
  int next_level() {
    if (flag_ == 1) throw std::length_error("the relabelling scan needs more than 254 grey levels");
    return --flag_;
  }

  Levels levels_;
  Index first_row_ = -1;  // none yet
  int flag_ = 255;
};

}  // namespace

LiteralHoles holes_literal(ConstImageView contours, ImageView labels) {
  Scan scan(contours);
  for (Index y = 0; y < contours.height; ++y) {
    for (Index x = 0; x < contours.width; ++x) {
      if (scan.levels().at(x, y) == kPoint) scan.visit(x, y);
    }
  }
  for (Index y = 0; y < contours.height; ++y) {
    for (Index x = 0; x < contours.width; ++x) labels.row(y)[x] = scan.levels().at(x, y);
  }
  return {scan.flag()};
}

void contours_of(ConstImageView source, ImageView destination) {
  const auto foreground = [&](Index x, Index y) {
    return x >= 0 && x < source.width && y >= 0 && y < source.height && source.row(y)[x] != 0;
  };
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) {
      const bool enclosed = foreground(x - 1, y) && foreground(x, y - 1) && foreground(x + 1, y) &&
                            foreground(x, y + 1);
      destination.row(y)[x] = foreground(x, y) && !enclosed ? kPoint : 0;
    }
  }
}

}  // namespace thinbench::reference
