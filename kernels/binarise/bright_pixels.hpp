// Counts of bright pixels, from which the foreground is chosen.
#pragma once

#include "thinbench/binarise.hpp"

namespace thinbench::detail {

/// The bright pixels of an image of two classes.
struct BrightPixels {
  Index bright = 0;
  Index all = 0;
  Index bright_on_border = 0;  // of the outermost rows and columns
  Index all_on_border = 0;
};

/// What was asked for or, if that is automatic, what Binarisation::foreground says.
[[nodiscard]] inline Foreground foreground_of(const BrightPixels& count, Foreground asked) {
  if (asked != Foreground::automatic) return asked;
  const Index on_border = 2 * count.bright_on_border - count.all_on_border;
  if (on_border != 0) return on_border < 0 ? Foreground::bright : Foreground::dark;
  return 2 * count.bright > count.all ? Foreground::dark : Foreground::bright;
}

[[nodiscard]] inline double foreground_share(const BrightPixels& count, Foreground foreground) {
  if (count.all == 0) return 0;
  const Index pixels = foreground == Foreground::bright ? count.bright : count.all - count.bright;
  return static_cast<double>(pixels) / static_cast<double>(count.all);
}

}  // namespace thinbench::detail
