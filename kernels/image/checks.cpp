#include "image/checks.hpp"

#include <stdexcept>

#include "thinbench/options.hpp"

namespace thinbench::detail {

void require(bool holds, const std::string& otherwise) {
  if (!holds) throw std::invalid_argument(otherwise);
}

std::string size_text(Index width, Index height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

void require_size(Index width, Index height) {
  require(width >= 0 && height >= 0, "image size " + size_text(width, height) + " is negative");
}

void require_max_pixels(Index width, Index height) {
  constexpr Index most = Index{1} << 40;
  require(width <= most && height <= most && (width == 0 || height <= most / width),
          "image size " + size_text(width, height) + " is larger than 2^40 pixels");
}

void require_threads(int threads) {
  require(threads >= 1 && threads <= kMaxThreads, "threads: expected an integer in [1, " + std::to_string(kMaxThreads) + "], got " + std::to_string(threads));
}

}  // namespace thinbench::detail
