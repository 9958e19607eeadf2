// Loops over registers.
#pragma once

#include <utility>

namespace thinbench::detail {

/// Calls `body` with integral constants 0 to count - 1.
template <int count, class Body>
[[gnu::always_inline]] inline void unrolled(const Body& body) {
  [&]<int... i>(std::integer_sequence<int, i...>) __attribute__((always_inline)) {
    (body(std::integral_constant<int, i>{}), ...);
  }
  (std::make_integer_sequence<int, count>{});
}

}  // namespace thinbench::detail
