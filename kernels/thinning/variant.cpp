#include "thinning/variant.hpp"

#include <stdexcept>
#include <string>

#include "thinning/plan.hpp"

namespace thinbench::detail {

bool knows_border(const ThinningVariant& variant, Border border) {
  using ByteCycle = std::span<const Pass<std::uint8_t>>;
  using BitCycle = std::span<const Pass<std::uint64_t>>;
  return border == Border::background || std::holds_alternative<ByteCycle>(variant.engine) ||
         std::holds_alternative<BitCycle>(variant.engine) ||
         std::holds_alternative<const ChangePass*>(variant.engine);
}

std::string_view unavailable_reason(const ThinningVariant& variant, Index width, Border border) {
  const std::string_view reason = unavailable_reason(facts_of(variant), width);
  if (!reason.empty()) return reason;
  return knows_border(variant, border) ? "" : kDoesNotKeepBorder;
}

std::vector<const ThinningVariant*> variants_for_border(const ThinningOperation& operation,
                                                        Border border) {
  std::vector<const ThinningVariant*> found;
  for (const ThinningVariant& one : operation.variants) {
    if (knows_border(one, border)) found.push_back(&one);
  }
  if (!found.empty()) return found;
  throw std::invalid_argument(std::string(operation.name) + " cannot keep the border");
}

}  // namespace thinbench::detail
