#include "api/catalogue.hpp"

#include <stdexcept>
#include <string>

#include "api/option_checks.hpp"
#include "custom/compiled_rule.hpp"
#include "custom/complement_state.hpp"
#include "custom/variants.hpp"
#include "image/checks.hpp"
#include "midpoints/variants.hpp"
#include "nets/variants.hpp"
#include "regions/variants.hpp"
#include "thinning/variants.hpp"

namespace thinbench::detail {
namespace {

std::vector<ThinningVariant> variants_of(Rule rule) {
  if (is_parallel_rule(rule)) return parallel_rule_variants(rule);
  if (rule == Rule::spta) return spta_variants();
  if (rule == Rule::midpoint_scan) return midpoint_variants();
  return net_variants(rule);
}

std::vector<ThinningOperation> make_thinning_operations() {
  std::vector<ThinningOperation> operations;
  for (const RuleInfo& info : kRules) {
    operations.push_back({info.rule, info.operation, info.description, variants_of(info.rule),
                          default_net(info.rule) != nullptr, info.rule == Rule::midpoint_scan});
  }
  return operations;
}

std::vector<EdgeOperation> make_edge_operations() {
  std::vector<EdgeOperation> operations;
  for (const EdgeOperatorInfo& info : kEdgeOperators) {
    operations.push_back({info.op, info.operation, info.description, edge_variants(info.op)});
  }
  return operations;
}

std::vector<RegionsOperation> make_regions_operations() {
  const auto operation = [](RegionsTask task, std::string_view name, std::string_view description) {
    return RegionsOperation{task, name, description, regions_variants(task)};
  };
  return {operation(RegionsTask::holes, "holes",
                    "objects (8-connected) and their holes, with areas and centres"),
          operation(RegionsTask::components, "components",
                    "objects (8-connected) alone, with areas and centres"),
          operation(RegionsTask::fill, "fill_holes",
                    "objects with all that they enclose, interior contours filled"),
          operation(RegionsTask::euler_eight, "euler_number",
                    "8-connected objects minus 4-connected holes"),
          operation(RegionsTask::euler_four, "euler_number_4",
                    "4-connected objects minus 8-connected holes")};
}

/// The operation whose member `key` has this value; `name` is for the message.
template <class Operations, class Key, class Value>
const auto& operation_with(const Operations& operations, Key key, Value value,
                           const std::string& name) {
  for (const auto& operation : operations) {
    if (operation.*key == value) return operation;
  }
  throw std::invalid_argument(name + ": expected one of the enumeration, got number " +
                              std::to_string(static_cast<int>(value)));
}

}  // namespace

std::span<const ThinningOperation> thinning_operations() {
  static const std::vector<ThinningOperation> operations = make_thinning_operations();
  return operations;
}

std::span<const EdgeOperation> edge_operations() {
  static const std::vector<EdgeOperation> operations = make_edge_operations();
  return operations;
}

std::span<const RegionsOperation> regions_operations() {
  static const std::vector<RegionsOperation> operations = make_regions_operations();
  return operations;
}

const LocaliseOperation& localise_operation() {
  static const LocaliseOperation operation = {
      "localise_objects",
      "grey image to Sobel's edges, contours, filled interiors and centres of objects and holes",
      localise_variants()};
  return operation;
}

const DistanceOperation& distance_operation() {
  static const DistanceOperation operation = {
      "squared_distances", "squares of Euclidean distances to the background", distance_variants()};
  return operation;
}

const GraphOperation& graph_operation() {
  static const GraphOperation operation = {
      "skeleton_graph", "ends, junctions and the lines between them", graph_variants()};
  return operation;
}

const ThinningOperation& operation_of(Rule rule) {
  return operation_with(thinning_operations(), &ThinningOperation::rule, rule, "rule");
}

const EdgeOperation& operation_of(EdgeOperator op) {
  return operation_with(edge_operations(), &EdgeOperation::op, op, "operator");
}

const RegionsOperation& operation_of(RegionsTask task) {
  return operation_with(regions_operations(), &RegionsOperation::task, task, "task");
}

Options with_useful_threads(const Options& options, bool can_share, Index width, Index height) {
  require_threads(options.threads);
  Options useful = options;
  const bool is_small = height <= 0 || width <= (kMinPixelsForThreads - 1) / height;
  if (!options.technique && (is_small || !can_share)) useful.threads = 1;
  return useful;
}

std::unique_ptr<ThinningState> make_state(const ThinningOperation& operation,
                                          const ThinningVariant& variant, Index width, Index height,
                                          const Options& options) {
  require_size(width, height);
  require_max_pixels(width, height);
  check_variant(variant, width, options);
  check_thinning_options(operation, options);
  return variant.make({operation.rule, variant.isa, width, height,
                       variant.threaded ? options.threads : 1, options.border,
                       options.max_iterations, options.directions,
                       options.net ? options.net : default_net(operation.rule)});
}

namespace {

struct CustomOperation {
  std::string_view name;
  std::vector<ThinningVariant> variants;
};

const CustomOperation& custom_operation(bool adds_pixels) {
  static const CustomOperation adds = {"apply", custom_variants(true)};
  static const CustomOperation only_removes = {"apply", custom_variants(false)};
  return adds_pixels ? adds : only_removes;
}

/// The rule's own border, or background if its tables were complemented instead.
Border border_of(const CustomRule& rule) {
  return rule.options().border == Border::keep ? Border::keep : Border::background;
}

}  // namespace

std::span<const ThinningVariant> custom_rule_variants(bool adds_pixels) {
  return custom_operation(adds_pixels).variants;
}

std::span<const ThinningVariant> custom_rule_variants(const CustomRule& rule) {
  return custom_rule_variants(rule.compiled()->adds_pixels());
}

const ThinningVariant& choose_custom(const CustomRule& rule, Index width, Index height,
                                     const Options& options) {
  require_size(width, height);
  check_no_thinning_options("a custom rule has its own options and", options);
  Options all = options;
  all.border = border_of(rule);
  return choose(custom_operation(rule.compiled()->adds_pixels()), width, height, all);
}

std::unique_ptr<ThinningState> make_custom_state(const CustomRule& rule,
                                                 const ThinningVariant& variant, Index width,
                                                 Index height, const Options& options) {
  require_size(width, height);
  require_max_pixels(width, height);
  check_variant(variant, width, options);
  ThinningSetting setting = {.rule = {},
                             .isa = variant.isa,
                             .width = width,
                             .height = height,
                             .threads = variant.threaded ? options.threads : 1,
                             .border = border_of(rule),
                             .max_iterations = rule.options().max_iterations,
                             .directions = {},
                             .custom_rule = rule.compiled()};
  auto state = variant.make(setting);
  if (rule.options().border != Border::foreground) return state;
  return std::make_unique<ComplementState>(std::move(state), width, height);
}

std::unique_ptr<EdgeState> make_state(const EdgeOperation& operation, const EdgeVariant& variant,
                                      Index width, Index height, const EdgeThresholds& thresholds,
                                      const Options& options) {
  require_size(width, height);
  require_max_pixels(width, height);
  check_variant(variant, width, options);
  check_no_thinning_options(operation.name, options);
  check_thresholds(thresholds);
  return variant.make({operation.op, thresholds, variant.isa, width, height,
                       variant.threaded ? options.threads : 1});
}

std::unique_ptr<RegionsState> make_state(const RegionsOperation& operation,
                                         const RegionsVariant& variant, Index width, Index height,
                                         const Options& options) {
  check_regions_size(width, height);
  check_variant(variant, width, options);
  check_no_thinning_options(operation.name, options);
  return variant.make(
      {operation.task, variant.isa, width, height, variant.threaded ? options.threads : 1});
}

std::unique_ptr<LocaliseState> make_state(const LocaliseOperation& operation,
                                          const LocaliseVariant& variant, Index width, Index height,
                                          const EdgeThresholds& thresholds,
                                          const Options& options) {
  check_regions_size(width, height);
  check_variant(variant, width, options);
  check_no_thinning_options(operation.name, options);
  check_thresholds(thresholds);
  return variant.make({EdgeOperator::sobel, thresholds, variant.isa, width, height,
                       variant.threaded ? options.threads : 1});
}

std::unique_ptr<DistanceState> make_state(const DistanceOperation& operation,
                                          const DistanceVariant& variant, Index width, Index height,
                                          const Options& options) {
  require_size(width, height);
  check_distance_size(width, height);
  check_variant(variant, width, options);
  check_no_thinning_options(operation.name, options);
  return variant.make({variant.isa, width, height, variant.threaded ? options.threads : 1});
}

std::unique_ptr<GraphState> make_state(const GraphOperation& operation, const GraphVariant& variant,
                                       Index width, Index height, const Options& options) {
  check_label_size(width, height);
  check_variant(variant, width, options);
  check_no_thinning_options(operation.name, options);
  return variant.make({variant.isa, width, height, variant.threaded ? options.threads : 1});
}

}  // namespace thinbench::detail
