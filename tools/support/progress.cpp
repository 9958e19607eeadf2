#include "support/progress.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include <unistd.h>

namespace thinbench {

Progress::Progress(std::string what, double total, std::string units)
    : what_(std::move(what)),
      total_(total),
      units_(std::move(units)),
      terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (terminal_) std::fputs("\r\033[K", stderr);
}

void Progress::advance(double done) {
  done_ += done;
  const auto now = Clock::now();
  const auto pause = terminal_ ? std::chrono::milliseconds(200) : std::chrono::seconds(10);
  if (now - latest_ < pause) return;
  latest_ = now;
  const std::string text = line();
  std::fprintf(stderr, terminal_ ? "\r\033[K%s" : "%s\n", text.c_str());
  std::fflush(stderr);
}

std::string Progress::line() const {
  const double share = std::clamp(done_ / total_, 0.001, 1.0);
  const double spent = std::chrono::duration<double>(Clock::now() - start_).count();
  const double left = spent * (1 - share) / share;
  std::array<char, 64> figures{};
  std::snprintf(figures.data(), figures.size(), ": %3.0f %%, about %.0f s left", 100 * share, left);
  std::array<char, 32> rate{};
  if (!units_.empty()) std::snprintf(rate.data(), rate.size(), ", %.0f ", done_ / spent);
  return what_ + figures.data() + rate.data() + (units_.empty() ? "" : units_ + "/s");
}

}  // namespace thinbench
