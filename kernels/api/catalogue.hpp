// All operations with their variants: public functions choose among them; tests and benchmarks
// iterate over them.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "distance/state.hpp"
#include "edges/state.hpp"
#include "graph/state.hpp"
#include "localise/state.hpp"
#include "regions/state.hpp"
#include "thinbench/custom_rule.hpp"
#include "thinning/state.hpp"

namespace thinbench::detail {

struct ThinningOperation {
  Rule rule;
  std::string_view name;
  std::string_view description;
  std::vector<ThinningVariant> variants;
  bool is_net;            // takes Options::net
  bool takes_directions;  // takes Options::directions; always one iteration
};

struct EdgeOperation {
  EdgeOperator op;
  std::string_view name;
  std::string_view description;
  std::vector<EdgeVariant> variants;
};

struct RegionsOperation {
  RegionsTask task;
  std::string_view name;
  std::string_view description;
  std::vector<RegionsVariant> variants;
};

struct LocaliseOperation {
  std::string_view name;
  std::string_view description;
  std::vector<LocaliseVariant> variants;
};

struct DistanceOperation {
  std::string_view name;
  std::string_view description;
  std::vector<DistanceVariant> variants;
};

struct GraphOperation {
  std::string_view name;
  std::string_view description;
  std::vector<GraphVariant> variants;
};

// All live as long as the program.
[[nodiscard]] std::span<const ThinningOperation> thinning_operations();
[[nodiscard]] std::span<const EdgeOperation> edge_operations();
[[nodiscard]] std::span<const RegionsOperation> regions_operations();
[[nodiscard]] const LocaliseOperation& localise_operation();
[[nodiscard]] const DistanceOperation& distance_operation();
[[nodiscard]] const GraphOperation& graph_operation();

[[nodiscard]] const ThinningOperation& operation_of(Rule rule);
[[nodiscard]] const EdgeOperation& operation_of(EdgeOperator op);
[[nodiscard]] const RegionsOperation& operation_of(RegionsTask task);

/// The variants of custom rules that add pixels, or of those that do not. They are none of
/// thinning_operations().
[[nodiscard]] std::span<const ThinningVariant> custom_rule_variants(bool adds_pixels);
[[nodiscard]] std::span<const ThinningVariant> custom_rule_variants(const CustomRule& rule);

// Make the state of a variant, which must belong to the operation. Throw std::invalid_argument as
// the public functions do, and std::bad_alloc.
[[nodiscard]] std::unique_ptr<ThinningState> make_state(const ThinningOperation& operation,
                                                        const ThinningVariant& variant, Index width,
                                                        Index height, const Options& options);
/// For a custom rule. Checks that the options have neither border nor limit nor anything else that
/// belongs to a rule.
[[nodiscard]] std::unique_ptr<ThinningState> make_custom_state(const CustomRule& rule,
                                                               const ThinningVariant& variant,
                                                               Index width, Index height,
                                                               const Options& options);
[[nodiscard]] std::unique_ptr<EdgeState> make_state(const EdgeOperation& operation,
                                                    const EdgeVariant& variant, Index width,
                                                    Index height, const EdgeThresholds& thresholds,
                                                    const Options& options);
[[nodiscard]] std::unique_ptr<RegionsState> make_state(const RegionsOperation& operation,
                                                       const RegionsVariant& variant, Index width,
                                                       Index height, const Options& options);
[[nodiscard]] std::unique_ptr<LocaliseState> make_state(const LocaliseOperation& operation,
                                                        const LocaliseVariant& variant, Index width,
                                                        Index height,
                                                        const EdgeThresholds& thresholds,
                                                        const Options& options);

[[nodiscard]] std::unique_ptr<DistanceState> make_state(const DistanceOperation& operation,
                                                        const DistanceVariant& variant, Index width,
                                                        Index height, const Options& options);

[[nodiscard]] std::unique_ptr<GraphState> make_state(const GraphOperation& operation,
                                                     const GraphVariant& variant, Index width,
                                                     Index height, const Options& options);

/// The options, but with one thread if they name no technique and the image is below 2^20 pixels or
/// no variant uses threads (`can_share` is false).
[[nodiscard]] Options with_useful_threads(const Options& options, bool can_share, Index width,
                                          Index height);

/// The variant for these options and this image size. Throws std::invalid_argument if the number of
/// threads is out of range or no variant fits.
template <class Operation>
[[nodiscard]] const auto& choose(const Operation& operation, Index width, Index height,
                                 const Options& options) {
  bool can_share = false;
  for (const auto& variant : operation.variants) can_share = can_share || variant.threaded;
  return choose_variant(operation.name, operation.variants, width,
                        with_useful_threads(options, can_share, width, height));
}

/// The same for a custom rule.
[[nodiscard]] const ThinningVariant& choose_custom(const CustomRule& rule, Index width,
                                                   Index height, const Options& options);

}  // namespace thinbench::detail
