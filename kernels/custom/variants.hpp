// The variants of custom rules.
#pragma once

#include <memory>
#include <vector>

#include "thinning/state.hpp"

namespace thinbench::detail {

/// The variants of rules that add pixels, or of those that do not. Settings must have a custom
/// rule; the border is background or keep.
[[nodiscard]] std::vector<ThinningVariant> custom_variants(bool adds_pixels);

/// Factories that nets share.
[[nodiscard]] std::unique_ptr<ThinningState> make_custom_bitpacked(const ThinningSetting& setting);
[[nodiscard]] std::unique_ptr<ThinningState> make_custom_simd_bitpacked(
    const ThinningSetting& setting);
[[nodiscard]] std::unique_ptr<ThinningState> make_custom_row(const ThinningSetting& setting);

}  // namespace thinbench::detail
