#include "regions/plan.hpp"

#include "image/checks.hpp"

namespace thinbench::detail {

void check_regions_plan(const VariantFacts& variant, Index width, Index height, int threads) {
  require_size(width, height);
  require(width <= kMaxHolesSide && height <= kMaxHolesSide,
          "image size " + size_text(width, height) + " has a side above 2^29 pixels");
  require(width == 0 || height <= kMaxHolesPixels / width,
          "image size " + size_text(width, height) + " is larger than 2^32 pixels");
  require_threads(threads);
  require_available(variant, width);
}

HolesPlan::HolesPlan(const HolesOperation& operation, const HolesVariant& variant, Index width,
                     Index height, int threads) {
  check_regions_plan(facts_of(variant), width, height, threads);
  state_ =
      variant.make({operation.task, variant.isa, width, height, variant.threaded ? threads : 1});
}

}  // namespace thinbench::detail
