// The paper's whole chain as one operation, and its variants: plain rows of a table.
#pragma once

#include <span>
#include <string_view>

#include "dispatch/variant_choice.hpp"

namespace thinbench::detail {

/// Edges as packed bits, the objects that they outline, and the regions of these: each row names
/// the technique by which the regions are found; edges are those of simd_to_bits at its level.
/// Threads share edges and regions; what the edges outline is found on one.
struct LocaliseVariant {
  VariantFacts facts;
};

struct LocaliseOperation {
  std::string_view name;
  std::string_view description;
  std::span<const LocaliseVariant> variants;
};

[[nodiscard]] std::span<const LocaliseVariant> localise_rows();

}  // namespace thinbench::detail
