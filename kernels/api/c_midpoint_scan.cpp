// The C interface of the midpoint scan.
#include "api/c_arguments.hpp"
#include "thinbench/midpoint_scan.hpp"

namespace {

using namespace thinbench;

static_assert(THINBENCH_ROWS == 1 << static_cast<int>(Direction::rows));
static_assert(THINBENCH_COLUMNS == 1 << static_cast<int>(Direction::columns));
static_assert(THINBENCH_DIAGONALS == 1 << static_cast<int>(Direction::diagonals));
static_assert(THINBENCH_ANTIDIAGONALS == 1 << static_cast<int>(Direction::antidiagonals));
static_assert(THINBENCH_ALL_DIRECTIONS == Directions{}.bits);

Directions directions_of(std::int32_t bits) {
  detail::require(0 <= bits && bits <= THINBENCH_ALL_DIRECTIONS, [&] {
    return "directions: expected bits in [0, 15], got " + std::to_string(bits);
  });
  return {static_cast<std::uint8_t>(bits)};
}

Border border_of(const char* name) {
  if (name == nullptr) return Border::background;
  return static_cast<Border>(detail::index_of("border", name, kBorderNames));
}

}  // namespace

thinbench_status thinbench_midpoint_scan(const thinbench_stack* source,
                                         const thinbench_output* destination, int32_t directions,
                                         const char* border, const thinbench_execution* execution) {
  return detail::guarded([&] {
    const ConstImageView image = detail::image_of(source);
    const StackView written = detail::destination_of(destination, detail::source_of(source));
    midpoint_scan(image, {written.data, image.width, image.height, written.stride},
                  directions_of(directions), border_of(border), detail::execution_of(execution));
    detail::set_foreground(destination, written);
  });
}
