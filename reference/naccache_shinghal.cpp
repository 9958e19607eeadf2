#include <utility>

#include "matrix.hpp"
#include "reference.hpp"

namespace thinbench::reference {
namespace {

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
  Matrix image = matrix_of(source);
  Matrix second(source.width, source.height);
  int scans = 0;
  for (bool flagged = true; flagged; ++scans) {
    flagged = false;
    for (Index y = 0; y < source.height; ++y) {
      for (Index x = 0; x < source.width; ++x) {
        const bool dark = image.dark(x, y);
        const bool kept = dark && stays(image, x, y);
        second.set(x, y, kept);
        flagged = flagged || kept != dark;
      }
    }
    std::swap(image, second);
  }
  write_matrix(image, destination);
  return scans;
}

}  // namespace thinbench::reference
