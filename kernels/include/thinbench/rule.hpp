// Rules: what thinning computes. A rule is built in, or has a name, or is given by tables, which a
// notation (thinbench/rule_notation.hpp) or the weights of a net also make. Every function that
// takes a rule takes all of them. CONTRIBUTING.md shows how to add a built-in one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "thinbench/enumeration.hpp"
#include "thinbench/export.h"
#include "thinbench/nets.hpp"
#include "thinbench/options.hpp"
#include "thinbench/window_table.hpp"

namespace thinbench {

/// Programs have the numbers compiled in: add at the end.
enum class BuiltInRule : std::uint8_t {
  naccache_shinghal,
  zhang_suen,
  zhang_suen_skimage,
  guo_hall,
  guo_hall_skimage,
  lu_wang,
  spta_directional,
  mb2,
};

struct RuleInfo {
  BuiltInRule rule;
  std::string_view name;
  std::string_view operation;  // its name as an operation, for example in results
  std::string_view description;
};

/// In the order of the enumeration.
inline constexpr std::array kRules = {
    RuleInfo{BuiltInRule::naccache_shinghal, "naccache_shinghal", "thin_naccache_shinghal",
             "modified Naccache-Shinghal rule, all removals of an iteration at once, as published"},
    RuleInfo{BuiltInRule::zhang_suen, "zhang_suen", "thin_zhang_suen",
             "Zhang and Suen 1984, two sub-iterations; loses 2 x 2 blocks"},
    RuleInfo{BuiltInRule::zhang_suen_skimage, "zhang_suen_skimage", "thin_zhang_suen_skimage",
             "scikit-image's skeletonize: zhang_suen with 31 decisions changed"},
    RuleInfo{BuiltInRule::guo_hall, "guo_hall", "thin_guo_hall",
             "Guo and Hall 1989, two sub-iterations; keeps topology"},
    RuleInfo{BuiltInRule::guo_hall_skimage, "guo_hall_skimage", "thin_guo_hall_skimage",
             "guo_hall with its sub-iterations exchanged: scikit-image's thin, bwmorph; keeps "
             "topology"},
    RuleInfo{BuiltInRule::lu_wang, "lu_wang", "thin_lu_wang",
             "Lu and Wang 1986, as Zhang and Suen but slanted lines keep their length"},
    RuleInfo{BuiltInRule::spta_directional, "spta_directional", "thin_spta_directional",
             "Naccache and Shinghal's SPTA, one direction after another; keeps topology"},
    RuleInfo{BuiltInRule::mb2, "mb2", "thin_mb2",
             "Bernard and Manzanera 1999, fully parallel, 5 x 5; keeps topology"},
};

/// This and rule_name throw std::invalid_argument for a value outside the enumeration.
[[nodiscard]] constexpr const RuleInfo& rule_info(BuiltInRule rule) {
  return detail::entry_of(kRules, rule, "rule");
}

[[nodiscard]] constexpr std::string_view rule_name(BuiltInRule rule) {
  return rule_info(rule).name;
}

/// The built-in rule of this name, or of the operation of this name.
[[nodiscard]] constexpr std::optional<BuiltInRule> rule_from_name(std::string_view name) {
  for (const RuleInfo& info : kRules) {
    if (info.name == name || info.operation == name) return info.rule;
  }
  return std::nullopt;
}

namespace detail {
struct RuleAccess;
struct RuleBody;
}  // namespace detail

/// What a rule that is given by tables says beside them.
struct RuleOptions {
  /// See Rule::border.
  Border border = Border::background;
  /// See Rule::max_iterations.
  int max_iterations = kUnlimited;
  /// Search longer for fewer gates: up to 2 s per table instead of 20 ms.
  bool optimise = false;
  /// For messages.
  std::string name = "custom";
};

/// A rule: one or more sub-iterations, each of which computes all pixels from the same image, as
/// tables of 3 x 3 pixels say (mb2 alone reads 5 x 5). The last iteration is the first in which no
/// sub-iteration changes a pixel, or the one at the limit.
///
/// Tables are compiled to circuits when first used, which takes up to 20 ms per table, or 2 s if
/// optimised; copies and, among the last 64, equal tables share what was compiled. Cheap to copy,
/// immutable and thread-safe. Constructors throw std::invalid_argument with one line that names the
/// value.
class THINBENCH_API Rule {
 public:
  using enum BuiltInRule;  // Rule::guo_hall
  static constexpr std::size_t kMaxSubIterations = 8;

  Rule(BuiltInRule rule);  // NOLINT(google-explicit-constructor): a name of a rule is a rule
  /// 1 to kMaxSubIterations tables.
  explicit Rule(std::span<const WindowTable> sub_iterations, const RuleOptions& options = {});
  /// One sub-iteration.
  explicit Rule(const WindowTable& table, const RuleOptions& options = {})
      : Rule(std::span(&table, 1), options) {}
  /// The table of a two-layer net, section 3.2 of the paper: a foreground pixel is kept where the
  /// output is at least 0.5. Weights are within [-1e30, 1e30].
  [[nodiscard]] static Rule from_net(const TwoLayerWeights& weights, Activation activation);
  /// That of a cluster, section 3.3. Its nets cover the descriptors 0 to 255 in order.
  [[nodiscard]] static Rule from_net(const ClusterWeights& weights);
  /// A built-in rule or one of named_rules(), by name. Also takes names of operations, such as
  /// thin_guo_hall.
  [[nodiscard]] static Rule named(std::string_view name);

  /// "guo_hall", "majority"; RuleOptions::name for tables, "net" for weights.
  [[nodiscard]] std::string_view name() const;
  /// What is outside the image unless a call says otherwise.
  [[nodiscard]] Border border() const;
  /// The limit unless a call says otherwise: kUnlimited, except for named rules that are meant to
  /// be applied once, and tables with a limit. A rule that both adds and removes pixels may never
  /// end, so it needs a limit.
  [[nodiscard]] int max_iterations() const;
  /// How far the effect of a pixel advances in an iteration, in rows and in columns: one pixel per
  /// sub-iteration, two in mb2.
  [[nodiscard]] int reach() const;
  /// One table per sub-iteration; empty for mb2, which is no function of 3 x 3 pixels.
  [[nodiscard]] std::span<const WindowTable> sub_iterations() const;
  /// The number of three-input gates of the circuit of a sub-iteration. Equal functions of
  /// different rows count once.
  [[nodiscard]] int gates(std::size_t sub_iteration) const;

 private:
  friend struct detail::RuleAccess;

  explicit Rule(std::shared_ptr<const detail::RuleBody> body) : body_(std::move(body)) {}

  std::shared_ptr<const detail::RuleBody> body_;
};

}  // namespace thinbench
