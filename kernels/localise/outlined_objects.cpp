#include "localise/outlined_objects.hpp"

namespace thinbench::detail {
namespace {

/// Writes what `change` makes of two images, word by word; they may be the target.
template <class Change>
void combine(const ConstBitPlaneView& a, const ConstBitPlaneView& b, const BitPlaneView& target,
             const Change& change) {
  for (Index y = 0; y < target.height; ++y) {
    for (Index word = 0; word < target.row_elements; ++word) {
      target.row(y)[word] = change(a.row(y)[word], b.row(y)[word]);
    }
  }
}

}  // namespace

OutlinedObjects::OutlinedObjects(Isa isa, Index width, Index height)
    : eight_(isa, {Connectivity::eight}),
      four_(isa, {Connectivity::four}),
      filled_(width, height),
      inner_(width, height) {}

void OutlinedObjects::write(const ConstBitPlaneView& contours, const BitPlaneView& target) {
  const auto both = [](std::uint64_t a, std::uint64_t b) { return a & b; };
  const auto without = [](std::uint64_t a, std::uint64_t b) { return a & ~b; };
  const BitPlaneView filled = filled_.view(), inner = inner_.view();
  eight_.fill(contours, filled);
  const BitPlaneView& enclosed = target;
  combine(filled, contours, enclosed, without);
  // From the border, through everything but the enclosed background, also diagonally, one reaches
  // the outermost contours, but not those inside.
  four_.fill(enclosed, inner);
  combine(inner, contours, inner, both);
  const BitPlaneView& holes = target;
  eight_.fill(inner, holes);
  combine(filled, holes, target, without);
}

}  // namespace thinbench::detail
