#include "holes/plan.hpp"

#include <stdexcept>
#include <string>

namespace thinbench {
namespace {

void require(bool holds, const std::string& otherwise) {
  if (!holds) throw std::invalid_argument(otherwise);
}

}  // namespace

void check_regions_plan(const VariantFacts& variant, Index width, Index height, int threads) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height);
  require(width >= 0 && height >= 0, "image size " + size + " is negative");
  require(width <= kMaxHolesSide && height <= kMaxHolesSide,
          "image size " + size + " has a side above 2^29 pixels");
  require(width == 0 || height <= kMaxHolesPixels / width,
          "image size " + size + " is larger than 2^32 pixels");
  require(threads >= 1 && threads <= kMostThreads,
          "threads is " + std::to_string(threads) + "; it must be in 1..1024");
  const std::string_view reason = why_unavailable(variant, width);
  require(reason.empty(), std::string(technique_name(variant.technique)) + " at " +
                              std::string(isa_name(variant.isa)) +
                              " cannot run: " + std::string(reason));
}

HolesPlan::HolesPlan(const HolesOperation& operation, const HolesVariant& variant, Index width,
                     Index height, int threads) {
  check_regions_plan(facts_of(variant), width, height, threads);
  state_ =
      variant.make({operation.task, variant.isa, width, height, variant.threaded ? threads : 1});
}

}  // namespace thinbench
