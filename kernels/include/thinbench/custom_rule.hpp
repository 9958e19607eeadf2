// Rules given as tables: any function of the 3 x 3 window of a pixel, compiled when they are first
// used.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "thinbench/export.h"
#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"

namespace thinbench {

namespace detail {
class CompiledRule;
}  // namespace detail

/// The new value of a pixel for each of the 512 values of its 3 x 3 window. Bit k of a window is
/// its pixel k in raster order:
///     0 1 2      bit 0 is the north-west neighbour, bit 4 the pixel itself,
///     3 4 5      bit 8 the south-east neighbour; foreground is 1
///     6 7 8
struct WindowTable {
  static constexpr std::size_t kWindows = 512;
  static constexpr std::size_t kCentre = 4;  // the bit of the pixel itself

  std::array<std::uint64_t, kWindows / 64> words{};  // window w is bit w % 64 of word w / 64

  constexpr bool operator[](std::size_t window) const {
    return (words[window / 64] >> (window % 64) & 1) != 0;
  }
  constexpr void set(std::size_t window, bool value) {
    const std::uint64_t bit = std::uint64_t{1} << (window % 64);
    words[window / 64] = value ? words[window / 64] | bit : words[window / 64] & ~bit;
  }
  friend constexpr bool operator==(const WindowTable&, const WindowTable&) = default;
};

/// The table of `next(window)`, which returns true for foreground.
template <class Next>
constexpr WindowTable make_window_table(const Next& next) {
  WindowTable table;
  for (std::size_t window = 0; window < WindowTable::kWindows; ++window) {
    table.set(window, static_cast<bool>(next(window)));
  }
  return table;
}

struct CustomRuleOptions {
  /// What lies outside the image; `keep`: background, and the outermost pixels never change.
  Border border = Border::background;
  /// At least 1. A rule that is not monotone needs a limit.
  int max_iterations = kUnlimited;
  /// Search longer for fewer gates: up to 2 s per table instead of 20 ms.
  bool optimise = false;
};

/// A rule of 1 to 8 sub-iterations, each a table. A sub-iteration computes all pixels from the same
/// image; an iteration applies every sub-iteration once. Iterations end when one changes nothing,
/// or at the limit. Without a limit the rule must be monotone: its tables only remove pixels, or
/// only add pixels. Compiled when first used, which takes up to 20 ms per table, or 2 s if
/// optimised; copies and, among the last 64, equal rules share what was compiled. Immutable and
/// thread-safe.
class THINBENCH_API CustomRule {
 public:
  static constexpr std::size_t kMaxSubIterations = 8;

  /// Throws std::invalid_argument for a number of tables or a limit out of range, and for a rule
  /// that is not monotone without a limit.
  explicit CustomRule(std::span<const WindowTable> sub_iterations,
                      const CustomRuleOptions& options = {});
  /// One sub-iteration.
  explicit CustomRule(const WindowTable& table, const CustomRuleOptions& options = {})
      : CustomRule(std::span(&table, 1), options) {}

  [[nodiscard]] std::span<const WindowTable> sub_iterations() const { return tables_; }
  [[nodiscard]] const CustomRuleOptions& options() const { return options_; }
  /// The number of three-input gates of a sub-iteration's circuit. Equal functions of different
  /// rows count once.
  [[nodiscard]] int gates(std::size_t sub_iteration) const;

  /// For internal use.
  [[nodiscard]] const std::shared_ptr<const detail::CompiledRule>& compiled() const {
    return compiled_;
  }

 private:
  std::vector<WindowTable> tables_;
  CustomRuleOptions options_;
  std::shared_ptr<const detail::CompiledRule> compiled_;
};

/// Applies a rule to `source` (0 is background, anything else is foreground) and writes the result
/// to `destination` (0 and 255). Returns the number of iterations, including the last one if it
/// changed nothing. Border and limit are those of the rule; of `options`, threads, isa and
/// technique apply. Views, errors and threads as for thin().
THINBENCH_API int apply(const CustomRule& rule, ConstImageView source, ImageView destination,
                        const Options& options = {});

}  // namespace thinbench
