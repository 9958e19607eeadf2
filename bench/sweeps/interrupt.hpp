// Ctrl-C that lets the sample in hand be finished.
#pragma once

#include <array>
#include <csignal>

namespace thinbench {

/// While it lives, the first SIGINT or SIGTERM is noted; another one ends the program at once.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  InterruptGuard(InterruptGuard&&) = delete;
  InterruptGuard& operator=(InterruptGuard&&) = delete;

 private:
  std::array<struct sigaction, 2> before_{};
};

[[nodiscard]] bool was_interrupted();

}  // namespace thinbench
