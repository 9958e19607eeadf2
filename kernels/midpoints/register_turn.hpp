// Rows that fit one register are turned there, without a ring in memory.
#pragma once

#include "image/plane_view.hpp"

namespace thinbench::detail {

/// Whether a word type can, and how: the row turned by `pixels` towards the east.
template <class Word>
struct RegisterTurn {
  static constexpr bool kAvailable = false;
};

}  // namespace thinbench::detail
