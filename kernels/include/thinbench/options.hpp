// Options of one call: what changes pixels, and how they are computed.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "thinbench/containers.hpp"
#include "thinbench/enumeration.hpp"
#include "thinbench/isa.hpp"

namespace thinbench {

/// What is outside the image, and whether the outermost pixels may change.
enum class Border : std::uint8_t {
  background,  // everything outside is background
  keep,        // the same, but the outermost rows and columns do not change (as OpenCV)
  foreground,  // everything outside is foreground
};

inline constexpr std::array<std::string_view, 3> kBorderNames = {"background", "keep",
                                                                 "foreground"};

/// Throws std::invalid_argument for a value outside the enumeration.
[[nodiscard]] constexpr std::string_view border_name(Border border) {
  return detail::entry_of(kBorderNames, border, "border");
}

[[nodiscard]] constexpr std::optional<Border> border_from_name(std::string_view name) {
  return detail::value_named<Border>(kBorderNames, name);
}

inline constexpr int kUnlimited = std::numeric_limits<int>::max();

/// What a call may change about a rule. Unset: as the rule says, see Rule::border and
/// Rule::max_iterations.
struct Thinning {
  std::optional<Border> border = std::nullopt;
  /// At least 1. An iteration applies every sub-iteration of the rule once.
  std::optional<int> max_iterations = std::nullopt;
};

inline constexpr int kMaxThreads = 1024;

/// How a result is computed. It never changes a pixel.
struct Execution {
  /// The maximum number of threads, from 1 to kMaxThreads. Images below 2^20 pixels use one thread,
  /// which is faster. Fewer are used where the system has or grants fewer; memory is for those.
  int threads = 1;
  /// The highest instruction set to use; an operation without code for exactly this one uses its
  /// next lower one. One that is not available on this machine is rejected. Default: the highest
  /// that is.
  std::optional<Isa> isa = std::nullopt;
};

}  // namespace thinbench
