// Midpoint scans, edges and distances: jobs of their states without a kernel scope.
#include "harness/library_operation.hpp"
#include "reference.hpp"
#include "thinbench/distance.hpp"

namespace thinbench {
namespace {

constexpr auto kRunToImage = [](auto& state, const auto& input, const auto& output, NoNumbers&) {
  state.run(input, output);
};

struct Distances : PixelNumbers {
  Distances(Index width, Index height) : PixelNumbers("squared distance", width, height) {}
};

Operation midpoint_operation(Border border) {
  Operation result = library_operation<NoNumbers>(
      detail::study::midpoint_operation(), {{}, border}, InputKind::binary, kRunToImage,
      job_maker<NoNumbers>([border](const auto& input, const auto& output, auto&) {
        reference::midpoint_scan({}, border, input, output);
      }));
  if (border == Border::keep) result.name += ":keep";
  result.border = border;
  result.timed = border == Border::background;
  return result;
}

}  // namespace

std::vector<Operation> midpoint_family() {
  return {midpoint_operation(Border::background), midpoint_operation(Border::keep)};
}

JobMaker edges_reference(EdgeOperator op, const EdgeThresholds& thresholds) {
  return job_maker<NoNumbers>(
      [function = reference::edges(op), thresholds](const auto& input, const auto& output, auto&) {
        function(thresholds, input, output);
      });
}

Operation edges_operation(const detail::EdgeOperation& operation,
                          const EdgeThresholds& thresholds) {
  return library_operation<NoNumbers>(operation, {operation.key, thresholds}, InputKind::grey,
                                      kRunToImage, edges_reference(operation.key, thresholds));
}

std::vector<Operation> edges_family() {
  std::vector<Operation> family;
  for (const detail::EdgeOperation& operation : detail::study::edge_operations()) {
    family.push_back(edges_operation(operation, {}));
  }
  return family;
}

std::vector<Operation> distance_family() {
  Operation result = library_operation<Distances>(
      detail::study::distance_operation(), {}, InputKind::binary,
      [](detail::DistanceState& state, const auto& input, const auto&, auto& distances) {
        state.run(input, distances.view());
      },
      job_maker<Distances>([](const auto& input, const auto&, auto& distances) {
        reference::squared_distances(input, distances.view());
      }));
  for (Variant& variant : result.variants) {
    variant.unavailable_reason = [own = variant.unavailable_reason](Index width) {
      return width <= kMaxDistanceSide ? own(width)
                                       : "wider than the limit for distances, " +
                                             std::to_string(kMaxDistanceSide) + " pixels";
    };
  }
  return {result};
}

}  // namespace thinbench
