// What a Rule has inside.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <variant>
#include <vector>

#include "compile/compiled_rule.hpp"
#include "thinbench/rule.hpp"

namespace thinbench::detail {

enum class RuleKind : std::uint8_t {
  parallel,   // sub-iterations compute all pixels from the same image
  spta,       // sequential
  midpoints,  // does not iterate
};

struct TwoLayerNet {
  TwoLayerWeights weights;
  Activation activation;
};
using NetWeights = std::variant<std::monostate, TwoLayerNet, ClusterWeights>;

/// Immutable.
struct RuleBody {
  std::string name;
  std::string operation;  // for messages: of a built-in rule, else the name
  RuleKind kind = RuleKind::parallel;
  int reach = 0;
  Border border = Border::background;
  int max_iterations = kUnlimited;
  /// The built-in rule whose circuits compute this rule; none: tables, compiled at run time.
  std::optional<BuiltInRule> circuits = std::nullopt;
  /// Rules that are functions of 3 x 3 pixels have tables, and a compiled form, made when needed.
  std::shared_ptr<const CompiledRule> compiled = nullptr;
  /// The same rule with foreground and background exchanged: for Border::foreground.
  std::shared_ptr<const RuleBody> complement = nullptr;
  Directions directions = {};  // of the midpoint scan
  NetWeights net = {};         // what the table of a net was made of

  [[nodiscard]] bool adds_pixels() const { return compiled && compiled->adds_pixels(); }
  [[nodiscard]] bool removes_pixels() const { return !compiled || compiled->removes_pixels(); }
};

using SharedRule = std::shared_ptr<const RuleBody>;

/// Binds a parallel rule: the only place that knows whether its scan functions come from compiled
/// C++, from emitted code or from an interpreter. With `fixed` every scan must have fixed pixels,
/// else none. Scans, or passes on tiles, are nullptr where there are none for the layout.
[[nodiscard]] BoundRule bind(const SharedRule& rule, Isa isa, Layout layout, bool fixed);

/// Whether registers of an ISA hold a row of 512 pixels, so that there is Layout::row.
[[nodiscard]] bool holds_row(Isa isa);

}  // namespace thinbench::detail
