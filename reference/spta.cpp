#include "reference.hpp"
#include "sub_iterations.hpp"

namespace thinbench::reference {
namespace {

/// Whether a dark pixel is an edge point of one side and the expression of that side is TRUE.
bool goes(const Neighbours& at, int side) {
  const auto& n = at.n;
  switch (side) {
    case 0:  // left: B4
      return !n[4] && n[0] && (n[1] || n[2] || n[6] || n[7]) && (n[2] || !n[3]) && (!n[5] || n[6]);
    case 1:  // right: B0
      return !n[0] && n[4] && (n[2] || n[3] || n[5] || n[6]) && (n[6] || !n[7]) && (!n[1] || n[2]);
    case 2:  // top: B2
      return !n[2] && n[6] && (n[0] || n[4] || n[5] || n[7]) && (n[0] || !n[1]) && (!n[3] || n[4]);
    default:  // bottom: B6
      return !n[6] && n[2] && (n[0] || n[1] || n[3] || n[4]) && (n[4] || !n[5]) && (!n[7] || n[0]);
  }
}

}  // namespace

int thin_spta_directional(Border border, ConstImageView source, ImageView destination) {
  const auto removed = [](const Matrix& image, Index x, Index y, int side) {
    return goes(neighbours_at(image, x, y), side);
  };
  return repeat_sub_iterations(4, border, source, destination, removed);
}

}  // namespace thinbench::reference
