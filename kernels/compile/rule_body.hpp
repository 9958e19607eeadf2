// What a Rule has inside.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "compile/compiled_rule.hpp"
#include "thinbench/rule.hpp"

namespace thinbench::detail {

/// Immutable. The study derives rules with more data.
struct RuleBody {
  RuleBody() = default;
  RuleBody(const RuleBody&) = default;
  RuleBody& operator=(const RuleBody&) = default;
  virtual ~RuleBody() = default;

  std::string name;
  Border border = Border::background;
  int max_iterations = kUnlimited;
  /// The built-in rule whose circuits compute this rule; none: tables, compiled at run time.
  std::optional<BuiltInRule> circuits = std::nullopt;
  /// Rules that are functions of 3 x 3 pixels have tables, and a compiled form, made when needed.
  std::shared_ptr<const CompiledRule> compiled = nullptr;
  /// The same rule with foreground and background exchanged: for Border::foreground.
  std::shared_ptr<const RuleBody> complement = nullptr;

  [[nodiscard]] bool adds_pixels() const { return compiled && compiled->adds_pixels(); }
  [[nodiscard]] bool removes_pixels() const { return !compiled || compiled->removes_pixels(); }
};

using SharedRule = std::shared_ptr<const RuleBody>;

struct RuleAccess {
  [[nodiscard]] static const SharedRule& body_of(const Rule& rule) { return rule.body_; }
  [[nodiscard]] static Rule make(SharedRule body) { return Rule(std::move(body)); }
};

[[nodiscard]] inline const SharedRule& body_of(const Rule& rule) {
  return RuleAccess::body_of(rule);
}

/// Binds a rule: the only place that knows whether its scan functions come from compiled C++, from
/// emitted code or from an interpreter. With `fixed` every scan must have fixed pixels, else none.
/// Scans, or passes on tiles, are nullptr where there are none for the layout.
[[nodiscard]] BoundRule bind(const SharedRule& rule, Isa isa, Layout layout, bool fixed);

/// Whether registers of an ISA hold a row of 512 pixels, so that there is Layout::row.
[[nodiscard]] bool holds_row(Isa isa);

}  // namespace thinbench::detail
