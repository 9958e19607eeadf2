#include "api/option_checks.hpp"

#include "image/checks.hpp"
#include "nets/model.hpp"
#include "thinbench/distance.hpp"

namespace thinbench::detail {
namespace {

bool is_for_rule(const NetModel& net, Rule rule) {
  if (rule == Rule::net_single_layer_cluster) return net.cluster.count > 0;
  const Activation activation =
      rule == Rule::net_two_layer_linear ? Activation::linear : Activation::sigmoid;
  return net.cluster.count == 0 && net.activation == activation;
}

void check_net(const ThinningOperation& operation, const std::shared_ptr<const NetModel>& net) {
  if (net == nullptr) return;
  const std::string name(operation.name);
  require(operation.is_net, name + " takes no weights");
  require(is_for_rule(*net, operation.rule),
          name + ": the weights are those of another kind of net");
}

}  // namespace

void check_variant(const VariantInfo& variant, Index width, const Options& options) {
  require_threads(options.threads);
  const std::string reason = unavailable_reason(variant, width, options.border);
  require(reason.empty(), std::string(technique_name(variant.technique)) + " at " +
                              std::string(isa_name(variant.isa)) + " cannot run: " + reason);
}

void check_regions_size(Index width, Index height) {
  require_size(width, height);
  require(width <= kMaxRegionsSide && height <= kMaxRegionsSide,
          "image size " + size_text(width, height) + " has a side above 2^29 pixels");
  require(width == 0 || height <= kMaxRegionsPixels / width,
          "image size " + size_text(width, height) + " is larger than 2^32 pixels");
}

void check_label_size(Index width, Index height) {
  constexpr Index max_pixels = Index{1} << 31;
  check_regions_size(width, height);
  require(width == 0 || height <= max_pixels / width,
          "image size " + size_text(width, height) +
              " is larger than 2^31 pixels, the limit for labels");
}

void check_distance_size(Index width, Index height) {
  require(width <= kMaxDistanceSide && height <= kMaxDistanceSide,
          "image size " + size_text(width, height) + " has a side above " +
              std::to_string(kMaxDistanceSide) + " pixels, the limit for distances");
}

void check_thinning_options(const ThinningOperation& operation, const Options& options) {
  const std::string name(operation.name);
  require(options.border == Border::background || options.border == Border::keep,
          "border: expected background or keep, got " +
              std::to_string(static_cast<int>(options.border)));
  require(options.max_iterations >= 1, "max_iterations: expected an integer of at least 1, got " +
                                           std::to_string(options.max_iterations));
  require(operation.takes_directions || options.directions == Directions{},
          name + " takes no directions");
  require(options.directions.bits >> kDirectionCount == 0,
          "directions: expected bits in [0, 15], got " + std::to_string(options.directions.bits));
  check_net(operation, options.net);
}

void check_no_thinning_options(std::string_view operation, const Options& options) {
  const std::string name(operation);
  require(options.border == Border::background, name + " takes no border");
  require(options.max_iterations == kUnlimited, name + " takes no max_iterations");
  require(options.directions == Directions{}, name + " takes no directions");
  require(options.net == nullptr, name + " takes no weights");
}

}  // namespace thinbench::detail
