// A thinning operation and its variants: plain rows of a table.
#pragma once

#include <span>
#include <string_view>
#include <variant>

#include "core/isa.hpp"
#include "core/technique.hpp"
#include "thinning/passes.hpp"
#include "thinning/row_kernel.hpp"

namespace thinbench {

/// A cycle of passes over byte planes or bit planes, repeated until nothing changes, or one kernel
/// that does all of it.
using ThinningEngine = std::variant<std::span<const Pass<std::uint8_t>>,
                                    std::span<const Pass<std::uint64_t>>, const RowKernel*>;

struct ThinningVariant {
  Technique technique;
  Isa isa;
  bool threaded;    // runs on bands of rows with as many threads as asked for
  Index max_width;  // wider images need another variant
  ThinningEngine engine;
};

struct ThinningOperation {
  std::string_view name;
  std::string_view description;
  std::span<const ThinningVariant> variants;
};

/// Why a variant cannot run here on an image of this width; empty where it can.
[[nodiscard]] std::string_view why_unavailable(const ThinningVariant& variant, Index width);

}  // namespace thinbench
