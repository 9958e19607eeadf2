// Tables whose index has another order of pixels.

#include <stdexcept>

#include "rules/window.hpp"
#include "thinbench/enumeration.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench {
namespace {

void check_values(std::span<const std::uint8_t> values, std::size_t count) {
  if (values.size() != count) {
    throw std::invalid_argument("expected " + std::to_string(count) + " values, got " +
                                std::to_string(values.size()));
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (values[i] > 1) {
      throw std::invalid_argument("value " + std::to_string(i + 1) + " of " +
                                  std::to_string(count) + ": expected 0 or 1, got " +
                                  std::to_string(values[i]));
    }
  }
}

/// The pixel of the window that bit `bit` of the index is.
std::size_t pixel_at(WindowOrder order, std::size_t bit) {
  const std::size_t k = order == WindowOrder::octave ? 8 - bit : bit;
  return order == WindowOrder::raster ? k : 3 * (k % 3) + k / 3;
}

void check_order(const NeighbourOrder& order) {
  std::size_t pixels = 0;
  for (const std::uint8_t pixel : order) {
    if (pixel <= 8) pixels |= std::size_t{1} << pixel;
  }
  if (pixels != detail::kRingBits) {
    throw std::invalid_argument(
        "an order of neighbours must name each of the pixels 0 to 3 and 5 to 8 once");
  }
}

}  // namespace

WindowTable table_from_values(std::span<const std::uint8_t> values, WindowOrder order) {
  detail::require_enumerator(order, 3, "order");
  check_values(values, WindowTable::kWindows);
  return make_window_table([&](std::size_t window) {
    std::size_t index = 0;
    for (std::size_t bit = 0; bit < 9; ++bit) {
      if (detail::pixel_of(window, pixel_at(order, bit))) index |= std::size_t{1} << bit;
    }
    return values[index];
  });
}

WindowTable table_from_removals(std::span<const std::uint8_t> removed,
                                const NeighbourOrder& order) {
  check_values(removed, 256);
  check_order(order);
  return make_window_table([&](std::size_t window) {
    std::size_t index = 0;
    for (std::size_t bit = 0; bit < order.size(); ++bit) {
      if (detail::pixel_of(window, order[bit])) index |= std::size_t{1} << bit;
    }
    return detail::pixel_of(window, WindowTable::kCentre) && removed[index] == 0;
  });
}

}  // namespace thinbench
