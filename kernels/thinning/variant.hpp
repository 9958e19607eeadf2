// A thinning operation and its variants: plain rows of a table.
#pragma once

#include <limits>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "dispatch/variant_choice.hpp"
#include "midpoints/work.hpp"
#include "thinning/border.hpp"
#include "thinning/engines/image_kernel.hpp"
#include "thinning/engines/lane_kernels.hpp"
#include "thinning/engines/passes.hpp"
#include "thinning/engines/row_kernel.hpp"
#include "thinning/rule_table.hpp"
#include "thinning/engines/tile_passes.hpp"

namespace thinbench::detail {

/// A cycle of passes over byte planes or bit planes, repeated until nothing changes; one pass that
/// sees what changed; a cycle over tiles; one kernel that does all of it; or the steps of a scan.
using ThinningEngine =
    std::variant<std::span<const Pass<std::uint8_t>>, std::span<const Pass<std::uint64_t>>,
                 const ChangePass*, TileEngine, const RowKernel*, const ImageKernel<std::uint8_t>*,
                 const ImageKernel<std::uint64_t>*, const ScanKernels*>;

/// A better engine for models that turn out to have the table of a known rule.
struct KnownRule {
  const RuleTable* table;
  ThinningEngine engine;
};

inline constexpr Index kAnyWidth = std::numeric_limits<Index>::max();
inline constexpr bool kThreaded = true;
inline constexpr bool kOneThread = false;

struct ThinningVariant {
  Technique technique;
  Isa isa;
  bool threaded;    // shares bands of rows, or tiles, among the threads asked for
  Index max_width;  // wider images need another variant
  ThinningEngine engine;
  std::span<const KnownRule> known_rules = {};  // for operations with a model
};

struct ThinningOperation {
  std::string_view name;
  std::string_view description;
  std::span<const ThinningVariant> variants;
  /// The model that is used where none is given; nullptr for operations without one.
  const RuleModel& (*default_model)() = nullptr;
  /// Passes at most; 1 for operations that are one pass.
  int max_iterations = std::numeric_limits<int>::max();
  Border border = Border::background;
  bool takes_directions = false;  // a scan
  /// For many small images at once; nullptr where there are none.
  const LaneKernelRows* lane_kernels = nullptr;
};

[[nodiscard]] inline VariantFacts facts_of(const ThinningVariant& variant) {
  return {variant.technique, variant.isa, variant.threaded, variant.max_width};
}

/// Whether a variant can treat the border so.
[[nodiscard]] bool knows_border(const ThinningVariant& variant, Border border);

/// The variants that can. Throws std::invalid_argument where there are none.
[[nodiscard]] std::vector<const ThinningVariant*> variants_for_border(
    const ThinningOperation& operation, Border border);

inline constexpr std::string_view kDoesNotKeepBorder = "this variant does not keep the border";

/// Why a variant cannot run here on an image of this width; empty where it can.
[[nodiscard]] std::string_view unavailable_reason(const ThinningVariant& variant, Index width,
                                               Border border = Border::background);

}  // namespace thinbench::detail
