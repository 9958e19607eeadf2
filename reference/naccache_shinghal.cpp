#include <utility>

#include "decisions.hpp"
#include "matrix.hpp"
#include "reference.hpp"
#include "sub_iterations.hpp"

namespace thinbench::reference {
namespace {

bool stays(const Matrix& image, Index x, Index y) {
  return stays_with(false_count<int>(expressions_of(neighbours_at(image, x, y).n)));
}

}  // namespace

int thin_naccache_shinghal(ConstImageView source, ImageView destination) {
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
