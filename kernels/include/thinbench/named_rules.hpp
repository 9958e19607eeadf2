// Rules given by tables, under the names by which they are known.
#pragma once

#include <span>
#include <string_view>

#include "thinbench/export.h"
#include "thinbench/rule.hpp"

namespace thinbench {

/// A rule with the options that its source gives it.
struct NamedRule {
  std::string_view name;
  std::string_view description;
  std::string_view source;
  std::span<const WindowTable> sub_iterations;
  Border border = Border::background;
  /// kUnlimited for rules that repeat until nothing changes, otherwise 1.
  int max_iterations = 1;
};

/// All named rules, sorted by name:
///
/// Operations of bwmorph, equal to those of Octave's image package 2.14 pixel for pixel: bridge,
/// clean, diag, dilate, endpoints, erode, fill, hbreak, majority, remove, spur, thin. One
/// iteration, the default of bwmorph, but thin repeats until nothing changes. With n > 1 bwmorph
/// still runs bridge, clean, fill, hbreak and remove once only.
///
/// Sequential thinning by hit-or-miss structuring elements, one per sub-iteration, until nothing
/// changes: gonzalez_woods and golay_l. Pruning likewise, but one iteration, in which every end
/// loses at least one pixel: prune.
///
/// life, Conway's game.
///
/// The nets of the paper, whose decisions are those of naccache_shinghal: net_two_layer_sigmoid and
/// net_two_layer_linear with its weights, net_single_layer_cluster with trained ones, as it
/// publishes none.
[[nodiscard]] THINBENCH_API std::span<const NamedRule> named_rules();

/// nullptr if there is no rule of this name.
[[nodiscard]] THINBENCH_API const NamedRule* find_named_rule(std::string_view name);

}  // namespace thinbench
