// The variants of iterated rules.
#pragma once

#include <vector>

#include "engines/state.hpp"

namespace thinbench::detail {

/// The variants of rules: of those with built-in circuits or of those given by tables, and of those
/// that add pixels or of those that do not.
[[nodiscard]] std::vector<ThinningVariant> parallel_variants(bool built_in, bool adds_pixels);

/// Whether scans get fixed pixels.
[[nodiscard]] bool has_fixed_pixels(const ThinningParameters& parameters);

/// States of engines.
[[nodiscard]] std::unique_ptr<ThinningState> make_words(const ThinningSetting& setting);
/// By a rule that is bound to Layout::words.
[[nodiscard]] std::unique_ptr<ThinningState> make_words(BoundRule rule,
                                                        const ThinningSetting& setting);
[[nodiscard]] std::unique_ptr<ThinningState> make_rows(const ThinningSetting& setting);
/// Tiles need compiled circuits or machine code. If the system denies machine code although it did
/// not before, or an image has more tiles than there are numbers, words compute the same.
[[nodiscard]] std::unique_ptr<ThinningState> make_tiles(const ThinningSetting& setting);

/// Priorities within an ISA: the highest is the fastest technique. Those below kWordsPriority are
/// of techniques that are compared with the product's.
enum ThinningPriority : int { kWordsPriority = 50, kTilesPriority, kRowPriority };

}  // namespace thinbench::detail
