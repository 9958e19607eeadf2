#include "cli/batch_operations.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/region_request.hpp"
#include "cli/scan_request.hpp"
#include "support/json_field.hpp"
#include "support/usage.hpp"
#include "thinbench/regions.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

constexpr const char* kHoles = "holes";
constexpr const char* kEdges = "edges";
constexpr const char* kLocalise = "localise";
constexpr const char* kGraph = "graph";

/// What the record of every operation says of the input.
void describe(const BinaryImage& binary, const BinariseOptions& options, BatchRecord& record) {
  record.foreground = std::string(foreground_name(binary.foreground));
  if (!options.local) record.threshold = binary.number();
  record.foreground_before = foreground_pixels(binary.image.view());
  std::vector<std::string> texts = warnings(binary, options);
  if (!record.warning.empty()) texts.insert(texts.begin(), record.warning);  // of the decoder
  record.warning = fmt::format("{}", fmt::join(texts, "; "));
}

void count(const Regions& found, BatchRecord& record) {
  record.objects = static_cast<std::int64_t>(found.objects.size());
  record.holes = static_cast<std::int64_t>(found.holes.size());
}

/// With the regions of the input.
void describe_regions(const BinaryImage& binary, const BinariseOptions& options,
                      const Execution& execution, BatchRecord& record) {
  describe(binary, options, record);
  count(find_regions(binary.image.view(), execution), record);
}

/// Thins images one after another. Memory is kept as long as their size is the same.
class ThinningCompute {
 public:
  ThinningCompute(RequestedThinning thinning, BinariseOptions binarise)
      : thinning_(std::move(thinning)), binarise_(binarise) {}

  BatchResult operator()(GreyImage grey, BatchRecord& record) {
    BinaryImage binary = binarise(std::move(grey), binarise_);
    describe_regions(binary, binarise_, {}, record);
    const ImageView image = binary.image.view();
    if (!thinner_ || image.width != width_ || image.height != height_) {
      thinner_ = std::make_shared<Thinner>(thinning_.rule, image.width, image.height,
                                           thinning_.thinning, thinning_.execution);
      width_ = image.width;
      height_ = image.height;
    }
    record.iterations = (*thinner_)(image, image);
    record.foreground_after = foreground_pixels(image);
    return {std::move(binary.image), {}};
  }

 private:
  RequestedThinning thinning_;
  BinariseOptions binarise_;
  std::shared_ptr<Thinner> thinner_;
  Index width_ = 0;
  Index height_ = 0;
};

BatchOperation thinning_operation(const BatchOperationRequest& request) {
  ThinningRequest words = request.thinning;
  words.other_operations = {kHoles, kEdges, kLocalise, kGraph, kScanOperation};
  for (const EdgeOperatorInfo& info : kEdgeOperators)
    words.other_operations.push_back(info.operation);
  const RequestedThinning thinning = requested_thinning(words);
  check_options(thinning);
  return {thinning.name + given_words(request.of_thinning) + thinning.contents,
          [thinning, binarise = request.binarise] { return ThinningCompute(thinning, binarise); }};
}

/// Owns no memory, so that threads may share `compute`.
BatchOperation without_memory(const std::string& name, const BatchCompute& compute) {
  return {name, [compute] { return compute; }};
}

BatchOperation scan_operation(const BatchOperationRequest& request) {
  const auto compute = [scan = requested_scan(request.thinning), options = request.binarise](
                           GreyImage grey, BatchRecord& record) -> BatchResult {
    BinaryImage binary = binarise(std::move(grey), options);
    describe_regions(binary, options, {}, record);
    scan.run(binary.image.view());
    record.iterations = 1;
    record.foreground_after = foreground_pixels(binary.image.view());
    return {std::move(binary.image), {}};
  };
  return without_memory(std::string(kScanOperation) + given_words(request.of_thinning), compute);
}

BatchResult compute_edges(GreyImage levels, BatchRecord& record,
                          const BatchOperationRequest& request, EdgeOperator op) {
  levels = in_bytes(std::move(levels));
  const BinaryImage binary = binarise(copy_of(levels), request.binarise);
  ByteImage& grey = levels.bytes;
  describe_regions(binary, request.binarise, {}, record);
  const EdgeThresholds thresholds = prepare_for_edges(grey, binary, request.edges);
  ByteImage edges(grey.width(), grey.height());
  detect_edges(op, grey.view(), edges.view(), thresholds, request.thinning.execution);
  record.foreground_after = foreground_pixels(edges.view());
  return {std::move(edges), {}};
}

BatchOperation edges_operation(const BatchOperationRequest& request) {
  const std::string& name = request.thinning.rule;
  const EdgeOperator op =
      name == kEdges ? EdgeOperator::sobel : edge_operator_from_name(name).value();
  const auto compute = [request, op](GreyImage grey, BatchRecord& record) {
    return compute_edges(std::move(grey), record, request, op);
  };
  return without_memory(
      std::string(edge_operator_info(op).operation) + given_words(request.of_edges), compute);
}

RegionRequest region_request(const BatchOperationRequest& request) {
  return {.localises = request.thinning.rule == kLocalise,
          .edges = request.edges,
          .binarise = request.binarise,
          .min_area = request.min_area.value_or(1),
          .draws = !request.overlay.empty(),
          .execution = request.thinning.execution};
}

BatchOperation regions_operation(const BatchOperationRequest& request) {
  const auto compute = [of = region_request(request)](GreyImage grey,
                                                      BatchRecord& record) -> BatchResult {
    BinaryImage binary = binarise(image_to_binarise(grey, of), of.binarise);
    describe(binary, of.binarise, record);
    DrawnRegions drawn =
        find_regions_in(std::move(grey), std::move(binary), {record.file, record.page}, of);
    count(drawn.found.regions, record);
    return {{},
            json_text(regions_json(drawn.found)),
            std::move(drawn.ground),
            std::move(drawn.overlay)};
  };
  const std::string area =
      request.min_area ? " --min-area " + std::to_string(*request.min_area) : "";
  return without_memory(request.thinning.rule + given_words(request.of_edges) + area, compute);
}

BatchResult compute_graph(GreyImage grey, BatchRecord& record,
                          const BatchOperationRequest& request) {
  check_sides(record.file, grey.width, grey.height);
  const bool draws = !request.overlay.empty();
  const BinaryImage binary = binarise(draws ? copy_of(grey) : std::move(grey), request.binarise);
  describe_regions(binary, request.binarise, {}, record);
  ByteImage skeleton = skeleton_of(binary.image, request.graph);
  const FoundGraph found =
      find_graph(binary.image, skeleton, {record.file, record.page}, request.graph);
  record.foreground_after = foreground_pixels(skeleton.view());
  BatchResult result = {{}, json_text(graph_json(found)), {}, {}};
  // NOLINTNEXTLINE(bugprone-use-after-move): where it draws, a copy was moved
  if (draws) result.ground = in_bytes(std::move(grey)).bytes;
  if (draws) result.overlay = graph_overlay(found);
  return result;
}

BatchOperation graph_operation(const BatchOperationRequest& request) {
  const std::string contents = checked_thinning(request.graph);
  const auto compute = [request](GreyImage grey, BatchRecord& record) {
    return compute_graph(std::move(grey), record, request);
  };
  return without_memory(kGraph + given_words(request.of_graphs) + contents, compute);
}

bool makes_edges(const BatchOperationRequest& request) {
  const std::string& name = request.thinning.rule;
  return name == kEdges || (name.starts_with("edges_") && edge_operator_from_name(name));
}

bool makes_regions(const BatchOperationRequest& request) {
  return request.thinning.rule == kHoles || request.thinning.rule == kLocalise;
}

BatchOperation operation_of(const BatchOperationRequest& request) {
  if (makes_graphs(request)) return graph_operation(request);
  if (makes_regions(request)) return regions_operation(request);
  if (makes_edges(request)) return edges_operation(request);
  if (makes_scan(request.thinning)) return scan_operation(request);
  return thinning_operation(request);
}

void check_applies(bool applies, const std::string& words, const BatchOperationRequest& request) {
  if (applies || words.empty()) return;
  throw UsageError(request.thinning.rule + " has no option" + words.substr(0, words.find(' ', 1)));
}

}  // namespace

bool makes_graphs(const BatchOperationRequest& request) {
  return request.thinning.rule == kGraph;
}

bool makes_json(const BatchOperationRequest& request) {
  return makes_regions(request) || makes_graphs(request);
}

BatchOperation batch_operation(const BatchOperationRequest& request) {
  const bool edges = makes_edges(request);
  const bool regions = makes_regions(request);
  const bool json = makes_json(request);
  check_applies(edges || request.thinning.rule == kLocalise, given_words(request.of_edges),
                request);
  check_applies(regions, request.min_area ? " --min-area" : "", request);
  check_applies(makes_graphs(request), given_words(request.of_graphs), request);
  check_applies(!edges && !json, given_words(request.of_thinning), request);
  check_applies(!json, request.format.empty() ? "" : " --format", request);
  const std::string overlay = request.overlay.empty() ? "" : " --overlay " + request.overlay;
  check_applies(json, overlay, request);
  check_applies(json, request.table.empty() ? "" : " --table", request);
  BatchOperation operation = operation_of(request);
  operation.name += given_words(request.of_binarise) + overlay;
  // On any image: rejects an ISA that it lacks before a file is written.
  BatchRecord ignored;
  static_cast<void>(operation.make()(GreyImage(ByteImage(8, 8)), ignored));
  return operation;
}

}  // namespace thinbench
