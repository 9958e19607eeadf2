// The line that `thinbench run` prints.
#pragma once

#include <string>

#include "thinbench/image_view.hpp"

namespace thinbench {

struct RunSummary {
  Index width;
  Index height;
  int iterations;
  Index foreground_before;
  Index foreground_after;
  double milliseconds;
};

/// "90 x 40, 7 iterations, 1200 foreground pixels before, 130 after, 0.042 ms".
[[nodiscard]] std::string text_of(const RunSummary& run);

}  // namespace thinbench
