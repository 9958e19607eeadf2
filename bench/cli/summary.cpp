#include "cli/summary.hpp"

#include <fmt/format.h>

namespace thinbench {

std::string text_of(const RunSummary& run) {
  return fmt::format("{} x {}, {} iteration{}, {} foreground pixels before, {} after, {:.3f} ms",
                     run.width, run.height, run.iterations, run.iterations == 1 ? "" : "s",
                     run.foreground_before, run.foreground_after, run.milliseconds);
}

}  // namespace thinbench
