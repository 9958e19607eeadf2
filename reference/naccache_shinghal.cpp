#include <utility>
#include <vector>

#include "reference.hpp"

namespace thinbench::reference {
namespace {

/// A matrix of dark (1) and light (0) pixels, one byte each, in a light frame one pixel wide.
class Matrix {
 public:
  Matrix(Index width, Index height)
      : stride_(width + 2), pixels_(static_cast<std::size_t>(stride_ * (height + 2))) {}

  [[nodiscard]] bool dark(Index x, Index y) const { return pixels_[index(x, y)] != 0; }
  void set(Index x, Index y, bool dark) { pixels_[index(x, y)] = dark ? 1 : 0; }

 private:
  [[nodiscard]] std::size_t index(Index x, Index y) const {
    return static_cast<std::size_t>((y + 1) * stride_ + x + 1);
  }

  Index stride_;
  std::vector<std::uint8_t> pixels_;
};

/// Whether a dark pixel stays: unless one or two of B0, B2, B4, B6 are FALSE.
bool stays(const Matrix& image, Index x, Index y) {
  const bool n0 = image.dark(x + 1, y);
  const bool n1 = image.dark(x + 1, y - 1);
  const bool n2 = image.dark(x, y - 1);
  const bool n3 = image.dark(x - 1, y - 1);
  const bool n4 = image.dark(x - 1, y);
  const bool n5 = image.dark(x - 1, y + 1);
  const bool n6 = image.dark(x, y + 1);
  const bool n7 = image.dark(x + 1, y + 1);
  const bool b4 = n0 && (n1 || n2 || n6 || n7) && (n2 || !n3) && (!n5 || n6);
  const bool b0 = n4 && (n2 || n3 || n5 || n6) && (n6 || !n7) && (!n1 || n2);
  const bool b2 = n6 && (n0 || n4 || n5 || n7) && (n0 || !n1) && (!n3 || n4);
  const bool b6 = n2 && (n0 || n1 || n3 || n4) && (n4 || !n5) && (!n7 || n0);
  const int false_count = !b0 + !b2 + !b4 + !b6;
  return false_count != 1 && false_count != 2;
}

}  // namespace

int thin_naccache_shinghal(ConstByteView source, ByteView destination) {
  const Index width = source.width;
  const Index height = source.height;
  Matrix image(width, height);
  for (Index y = 0; y < height; ++y) {
    for (Index x = 0; x < width; ++x) image.set(x, y, source.row(y)[x] != 0);
  }
  Matrix second(width, height);
  int scans = 0;
  for (bool flagged = true; flagged; ++scans) {
    flagged = false;
    for (Index y = 0; y < height; ++y) {
      for (Index x = 0; x < width; ++x) {
        const bool dark = image.dark(x, y);
        const bool kept = dark && stays(image, x, y);
        second.set(x, y, kept);
        flagged = flagged || kept != dark;
      }
    }
    std::swap(image, second);
  }
  for (Index y = 0; y < height; ++y) {
    for (Index x = 0; x < width; ++x) destination.row(y)[x] = image.dark(x, y) ? 255 : 0;
  }
  return scans;
}

}  // namespace thinbench::reference
