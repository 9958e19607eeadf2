// Rules: what thinning computes. A rule is built in, or has a name, or is given by tables, by a
// notation (thinbench/rule_notation.hpp) or by the weights of a net. Every function that takes a
// rule takes all of them. CONTRIBUTING.md shows how to add a built-in one.
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
  spta,
  spta_directional,
  mb2,
  midpoint_scan,
  net_two_layer_sigmoid,
  net_two_layer_rounded,
  net_two_layer_linear,
  net_single_layer_cluster,
};

struct RuleInfo {
  BuiltInRule rule;
  std::string_view name;
  std::string_view operation;  // its name as an operation, for example in results
  /// How far the effect of a pixel advances in an iteration, in rows and in columns: one pixel per
  /// sub-iteration, two where a rule reads 5 x 5 pixels. 0: without a bound, as in sequential
  /// scans.
  int reach;
  std::string_view description;
};

/// In the order of the enumeration.
inline constexpr std::array kRules = {
    RuleInfo{BuiltInRule::naccache_shinghal, "naccache_shinghal", "thin_naccache_shinghal", 1,
             "modified Naccache-Shinghal rule, all removals of an iteration at once, as published"},
    RuleInfo{BuiltInRule::zhang_suen, "zhang_suen", "thin_zhang_suen", 2,
             "Zhang and Suen 1984, two sub-iterations; loses 2 x 2 blocks"},
    RuleInfo{BuiltInRule::zhang_suen_skimage, "zhang_suen_skimage", "thin_zhang_suen_skimage", 2,
             "scikit-image's skeletonize: zhang_suen with 31 decisions changed"},
    RuleInfo{BuiltInRule::guo_hall, "guo_hall", "thin_guo_hall", 2,
             "Guo and Hall 1989, two sub-iterations; keeps topology"},
    RuleInfo{BuiltInRule::guo_hall_skimage, "guo_hall_skimage", "thin_guo_hall_skimage", 2,
             "guo_hall with its sub-iterations exchanged: scikit-image's thin, bwmorph; keeps "
             "topology"},
    RuleInfo{BuiltInRule::lu_wang, "lu_wang", "thin_lu_wang", 2,
             "Lu and Wang 1986, as Zhang and Suen but slanted lines keep their length"},
    RuleInfo{BuiltInRule::spta, "spta", "thin_spta", 0,
             "Naccache and Shinghal's SPTA as published, two sequential scans per iteration, one "
             "thread; keeps topology"},
    RuleInfo{BuiltInRule::spta_directional, "spta_directional", "thin_spta_directional", 4,
             "Naccache and Shinghal's SPTA, one direction after another; keeps topology"},
    RuleInfo{BuiltInRule::mb2, "mb2", "thin_mb2", 2,
             "Bernard and Manzanera 1999, fully parallel, 5 x 5; keeps topology"},
    RuleInfo{BuiltInRule::midpoint_scan, "midpoint_scan", "skeleton_scan", 0,
             "the paper's own method: midpoints of foreground runs along rows, columns and both "
             "diagonals"},
    RuleInfo{BuiltInRule::net_two_layer_sigmoid, "net_two_layer_sigmoid", "net_two_layer_sigmoid",
             1,
             "the two-layer net of Table 1 with sigmoid (1); hidden values across lanes agree "
             "within 2 units in the last place, outputs within 9"},
    RuleInfo{BuiltInRule::net_two_layer_rounded, "net_two_layer_rounded", "net_two_layer_rounded",
             1, "net_two_layer_sigmoid with weights rounded to integers: not quite the rule"},
    RuleInfo{BuiltInRule::net_two_layer_linear, "net_two_layer_linear", "net_two_layer_linear", 1,
             "the two-layer net of Table 1 with linear threshold (2); all values agree bit for "
             "bit"},
    RuleInfo{BuiltInRule::net_single_layer_cluster, "net_single_layer_cluster",
             "net_single_layer_cluster", 1,
             "the cluster of twelve single-layer nets, equations (5) to (7)"},
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

/// A direction in which the midpoint scan finds runs of foreground pixels.
enum class Direction : std::uint8_t {
  rows,           // west to east
  columns,        // north to south
  diagonals,      // north-west to south-east
  antidiagonals,  // north-east to south-west
};

inline constexpr std::array kAllDirections = {Direction::rows, Direction::columns,
                                              Direction::diagonals, Direction::antidiagonals};
inline constexpr int kDirectionCount = 4;
inline constexpr std::array<std::string_view, kDirectionCount> kDirectionNames = {
    "rows", "columns", "diagonals", "antidiagonals"};

/// A set of directions; bit i stands for static_cast<Direction>(i). Default: all.
struct Directions {
  std::uint8_t bits = (1 << kDirectionCount) - 1;

  [[nodiscard]] constexpr bool has(Direction direction) const {
    return (bits >> static_cast<int>(direction) & 1) != 0;
  }
  constexpr void add(Direction direction) {
    bits = static_cast<std::uint8_t>(bits | 1 << static_cast<int>(direction));
  }
  friend constexpr bool operator==(Directions, Directions) = default;
};

inline constexpr Directions kNoDirections = {0};

namespace detail {
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

/// A rule: one or more sub-iterations, each of which computes all pixels from the same image. (The
/// exceptions are spta, which is sequential, and midpoint_scan, which does not iterate.) Iterations
/// end when one changes nothing, or at the limit.
///
/// Tables are compiled to circuits when first used, which takes up to 20 ms per table, or 2 s if
/// optimised; copies and, among the last 64, equal tables share what was compiled. Cheap to copy,
/// immutable and thread-safe. Constructors throw std::invalid_argument with one line that names the
/// value.
class THINBENCH_API Rule {
 public:
  using enum BuiltInRule;  // Rule::guo_hall
  static constexpr std::size_t kMaxSubIterations = 8;

  /// Nets have the paper's weights or, for the cluster, which it does not publish, trained ones.
  Rule(BuiltInRule rule);  // NOLINT(google-explicit-constructor): a name of a rule is a rule
  /// 1 to kMaxSubIterations tables.
  explicit Rule(std::span<const WindowTable> sub_iterations, const RuleOptions& options = {});
  /// One sub-iteration.
  explicit Rule(const WindowTable& table, const RuleOptions& options = {})
      : Rule(std::span(&table, 1), options) {}
  /// The net of section 3.2 of the paper: a foreground pixel is kept where its output is at least
  /// 0.5. Weights are within [-1e30, 1e30].
  Rule(const TwoLayerWeights& weights, Activation activation);
  /// The cluster of section 3.3. Its nets cover the descriptors 0 to 255 in order.
  explicit Rule(const ClusterWeights& weights);
  /// The midpoint scan in some directions only.
  explicit Rule(Directions directions);
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
  /// As RuleInfo::reach.
  [[nodiscard]] int reach() const;
  /// One table per sub-iteration; empty for spta, mb2 and midpoint_scan, which are no functions of
  /// 3 x 3 pixels.
  [[nodiscard]] std::span<const WindowTable> sub_iterations() const;
  /// The number of three-input gates of the circuit of a sub-iteration. Equal functions of
  /// different rows count once.
  [[nodiscard]] int gates(std::size_t sub_iteration) const;

  /// For internal use.
  [[nodiscard]] const std::shared_ptr<const detail::RuleBody>& body() const { return body_; }

 private:
  explicit Rule(std::shared_ptr<const detail::RuleBody> body) : body_(std::move(body)) {}

  std::shared_ptr<const detail::RuleBody> body_;
};

}  // namespace thinbench
