#include "experiments/thinning_quality.hpp"

#include <algorithm>
#include <regex>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "harness/image_names.hpp"
#include "harness/operation.hpp"
#include "harness/test_images.hpp"
#include "images/image_file.hpp"
#include "scene/scene.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::ordered_json;

constexpr Index kBlobSide = 256;
constexpr Index kBlobReach = 4;

/// All rules that thin but nets, of which those that matter have the paper's rule, and the scan.
std::vector<std::string_view> measured_operations() {
  std::vector<std::string_view> names;
  for (const RuleInfo& info : kRules) {
    if (info.rule == BuiltInRule::spta_directional) names.push_back("thin_spta");
    names.push_back(info.operation);
  }
  names.push_back("midpoint_scan");
  return names;
}

/// The inputs that are always there, and names that the skeleton of another input would have.
std::regex reserved_names() {
  return std::regex(fmt::format("scene|blobs|.*_({})", fmt::join(measured_operations(), "|")));
}

Outcome thinned(std::string_view operation, const ConstImageView& image) {
  const auto& variants = operation_of(operation).variants;
  const auto usable = std::find_if(variants.rbegin(), variants.rend(), [&](const Variant& one) {
    return !one.is_peer && one.unavailable_reason(image.width).empty();
  });
  return outcome_of(*usable->make_job(image.width, image.height, 1), image);
}

/// Of an outcome; the scan has one.
std::int64_t iterations_of(const Outcome& outcome) {
  return outcome.numbers.empty() ? 1 : outcome.numbers.front();
}

ByteImage rotated(const ConstImageView& image, int quarters) {
  ByteImage result = copy_of(image);
  for (int turn = 0; turn < quarters; ++turn) result = rotated_by_quarter(result.view());
  return result;
}

/// With the skeletons of the image rotated by one, two and three quarters, each rotated back.
double min_overlap(std::string_view operation, const ConstImageView& image,
                   const ConstImageView& skeleton) {
  double least = 1;
  for (int quarters = 1; quarters < 4; ++quarters) {
    const ByteImage other = thinned(operation, rotated(image, quarters).view()).image;
    least = std::min(least, overlap(skeleton, rotated(other.view(), 4 - quarters).view()));
  }
  return least;
}

Json measure(std::string_view operation, const QualityInput& input, const Topology& before,
             const ByteImage& axis) {
  const ConstImageView image = input.image.view();
  const Outcome result = thinned(operation, image);
  const ConstImageView skeleton = result.image.view();
  const Topology after = topology_of(skeleton);
  const SkeletonShape shape = shape_of(skeleton);
  const AxisDistance from_axis = distance_from(axis.view(), skeleton);
  return {{"operation", operation},
          {"border", border_name(Border::background)},
          {"max_iterations", nullptr},
          {"input", input.name},
          {"objects_before", before.objects},
          {"objects_after", after.objects},
          {"holes_before", before.holes},
          {"holes_after", after.holes},
          {"pixels", shape.pixels},
          {"blocks", shape.blocks},
          {"ends", shape.ends},
          {"branches", shape.branches},
          {"mean_distance", from_axis.mean},
          {"largest_distance", from_axis.largest},
          {"min_symmetry", min_overlap(operation, image, skeleton)},
          {"iterations", iterations_of(result)}};
}

int foreground_round(const ByteImage& noise, Index x, Index y) {
  int foreground = 0;
  for (Index row = std::max<Index>(0, y - kBlobReach);
       row <= std::min(noise.height() - 1, y + kBlobReach); ++row) {
    for (Index column = std::max<Index>(0, x - kBlobReach);
         column <= std::min(noise.width() - 1, x + kBlobReach); ++column) {
      foreground += noise.at(column, row) != 0 ? 1 : 0;
    }
  }
  return foreground;
}

}  // namespace

ByteImage blobs(Index width, Index height, std::uint64_t seed) {
  constexpr int most = (2 * kBlobReach + 1) * (2 * kBlobReach + 1) / 2;
  const ByteImage noise = noise_image(width, height, 50, 1, seed);
  return image_by(width, height,
                  [&](Index x, Index y) { return foreground_round(noise, x, y) > most ? 255 : 0; });
}

std::vector<QualityInput> quality_inputs(const std::vector<std::string>& images,
                                         const BinariseOptions& binarise, std::ostream* log) {
  std::vector<QualityInput> inputs;
  inputs.push_back({"scene", std::move(render_scene().binary)});
  inputs.push_back({"blobs", blobs(kBlobSide, kBlobSide, 1)});
  const std::regex reserved = reserved_names();
  for (const std::string& path : images) {
    inputs.push_back(
        {image_name(path, names_of(inputs), reserved), read_binary(path, binarise, log)});
  }
  return inputs;
}

void write_skeletons(const std::string& directory, const std::vector<QualityInput>& inputs) {
  for (const QualityInput& input : inputs) {
    const std::string stem = directory + "/quality_" + input.name;
    write_grey(stem + ".png", input.image.view());
    for (const std::string_view operation : measured_operations()) {
      write_grey(fmt::format("{}_{}.png", stem, operation),
                 thinned(operation, input.image.view()).image.view());
    }
  }
}

ExperimentReport thinning_quality(const std::vector<QualityInput>& inputs,
                                  const std::string& options) {
  Json rows = Json::array();
  for (const QualityInput& input : inputs) {
    const Topology before = topology_of(input.image.view());
    const ByteImage axis = medial_axis_of(input.image.view());
    for (const std::string_view operation : measured_operations()) {
      rows.push_back(measure(operation, input, before, axis));
    }
  }
  return report_of(
      "quality",
      "Skeletons. Distances are from the ridge of the exact distance map, in pixels; least "
      "symmetry "
      "is the smallest overlap with the skeletons of the input rotated by 90, 180 and 270 degrees:",
      {{"rows", rows}}, options);
}

}  // namespace thinbench
