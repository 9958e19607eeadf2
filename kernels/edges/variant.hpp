// Edge operations and their variants: plain rows of a table.
#pragma once

#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "dispatch/variant_choice.hpp"
#include "edges/kernels.hpp"

namespace thinbench::detail {

struct EdgeVariant {
  VariantFacts facts;
  std::variant<EdgesToBytes, EdgesToBits> kernel;

  [[nodiscard]] bool writes_bits() const { return std::holds_alternative<EdgesToBits>(kernel); }
};

struct EdgeOperation {
  std::string_view name;
  std::string_view description;
  EdgeOperator op;
  std::vector<EdgeVariant> variants;
};

/// All variants of an operator.
[[nodiscard]] std::vector<EdgeVariant> edge_rows(EdgeOperator op);

}  // namespace thinbench::detail
