#include "cli/batch_operations.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "cli/region_formats.hpp"
#include "cli/usage.hpp"
#include "images/regions.hpp"
#include "thinbench/localise.hpp"
#include "thinbench/regions.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

constexpr const char* kHoles = "holes";
constexpr const char* kEdges = "edges";
constexpr const char* kLocalise = "localise";

/// What the record of every operation says of the input; returns its regions.
Regions describe(const BinaryImage& binary, const BinariseOptions& options,
                 const Execution& execution, BatchRecord& record) {
  Regions found = find_regions(binary.image.view(), execution);
  std::int64_t pixels = 0;
  for (const Region& object : found.objects) pixels += object.area;
  record.foreground = std::string(foreground_name(binary.foreground));
  record.threshold = binary.threshold;
  record.foreground_before = pixels;
  record.components = static_cast<std::int64_t>(found.objects.size());
  record.holes = static_cast<std::int64_t>(found.holes.size());
  std::vector<std::string> texts = warnings(binary, options);
  if (!record.warning.empty()) texts.insert(texts.begin(), record.warning);  // of the decoder
  record.warning = fmt::format("{}", fmt::join(texts, "; "));
  return found;
}

/// Thins images one after another. Memory is kept as long as their size is the same.
class ThinningCompute {
 public:
  ThinningCompute(RequestedThinning thinning, BinariseOptions binarise)
      : thinning_(std::move(thinning)), binarise_(binarise) {}

  BatchResult operator()(ByteImage grey, BatchRecord& record) {
    BinaryImage binary = binarise(std::move(grey), binarise_);
    describe(binary, binarise_, {}, record);
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
  const RequestedThinning thinning = requested_thinning(request.thinning);
  return {thinning.name + thinning_words(request.thinning),
          [thinning, binarise = request.binarise] { return ThinningCompute(thinning, binarise); }};
}

BatchResult compute_edges(ByteImage grey, BatchRecord& record, const BatchOperationRequest& request,
                          EdgeOperator op) {
  const BinaryImage binary = binarise(copy_of(grey.view()), request.binarise);
  describe(binary, request.binarise, {}, record);
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
  const auto compute = [request, op](ByteImage grey, BatchRecord& record) {
    return compute_edges(std::move(grey), record, request, op);
  };
  return {std::string(edge_operator_info(op).operation) + edge_words(request.edges),
          [compute] { return compute; }};
}

BatchResult compute_holes(ByteImage grey, BatchRecord& record,
                          const BatchOperationRequest& request) {
  const BinaryImage binary = binarise(std::move(grey), request.binarise);
  const std::int64_t min_area = request.min_area.value_or(1);
  const Regions all = describe(binary, request.binarise, request.thinning.execution, record);
  const Regions found = selected(all, kept_regions(all, min_area));
  record.components = static_cast<std::int64_t>(found.objects.size());
  record.holes = static_cast<std::int64_t>(found.holes.size());
  return {{},
          regions_json({record.file, binary.image.width(), binary.image.height(), found, min_area},
                       choice_of(binary, request.binarise))};
}

BatchResult compute_localise(ByteImage grey, BatchRecord& record,
                             const BatchOperationRequest& request) {
  const BinaryImage binary = binarise(copy_of(grey.view()), request.binarise);
  describe(binary, request.binarise, request.thinning.execution, record);
  const std::int64_t min_area = request.min_area.value_or(1);
  const EdgeThresholds thresholds = prepare_for_edges(grey, binary, request.edges);
  const Regions all = localise_objects(grey.view(), thresholds, request.thinning.execution);
  const Regions found = selected(all, kept_regions(all, min_area));
  record.components = static_cast<std::int64_t>(found.objects.size());
  record.holes = static_cast<std::int64_t>(found.holes.size());
  return {{},
          regions_json({record.file, grey.width(), grey.height(), found, min_area},
                       choice_of(binary, request.binarise))};
}

BatchOperation regions_operation(const BatchOperationRequest& request) {
  const auto compute = [request](ByteImage grey, BatchRecord& record) {
    return request.thinning.rule == kHoles ? compute_holes(std::move(grey), record, request)
                                           : compute_localise(std::move(grey), record, request);
  };
  const std::string area =
      request.min_area ? " --min-area " + std::to_string(*request.min_area) : "";
  return {request.thinning.rule + edge_words(request.edges) + area, [compute] { return compute; }};
}

bool makes_edges(const BatchOperationRequest& request) {
  const std::string& name = request.thinning.rule;
  return name == kEdges || (name.rfind("edges_", 0) == 0 && edge_operator_from_name(name));
}

BatchOperation operation_of(const BatchOperationRequest& request) {
  if (makes_regions(request)) return regions_operation(request);
  if (makes_edges(request)) return edges_operation(request);
  return thinning_operation(request);
}

void check_applies(bool applies, const std::string& words, const BatchOperationRequest& request) {
  if (applies || words.empty()) return;
  throw UsageError(request.thinning.rule + " has no option" + words.substr(0, words.find(' ', 1)));
}

}  // namespace

bool makes_regions(const BatchOperationRequest& request) {
  return request.thinning.rule == kHoles || request.thinning.rule == kLocalise;
}

BatchOperation batch_operation(const BatchOperationRequest& request) {
  const bool edges = makes_edges(request);
  const bool regions = makes_regions(request);
  check_applies(edges || request.thinning.rule == kLocalise, edge_words(request.edges), request);
  check_applies(regions, request.min_area ? " --min-area" : "", request);
  check_applies(!edges && !regions, thinning_words(request.thinning), request);
  BatchOperation operation = operation_of(request);
  operation.name += binarise_words(request.binarise);
  // On any image: rejects an ISA that it lacks before a file is written.
  BatchRecord ignored;
  static_cast<void>(operation.make()(ByteImage(8, 8), ignored));
  return operation;
}

}  // namespace thinbench
