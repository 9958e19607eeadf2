#include "experiments/thinning_quality.hpp"

#include <algorithm>
#include <regex>

#include <nlohmann/json.hpp>

#include "api/catalogue.hpp"
#include "harness/test_images.hpp"
#include "picture/picture.hpp"
#include "scene/scene.hpp"
#include "support/picture_names.hpp"
#include "support/text.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

constexpr Index kBlobSide = 256;
constexpr Index kBlobReach = 4;

std::vector<Rule> measured_rules() {
  std::vector<Rule> rules;
  for (const detail::ThinningOperation& operation : detail::thinning_operations()) {
    if (!operation.is_net) rules.push_back(operation.rule);
  }
  return rules;
}

std::string name_of(Rule rule) {
  return std::string(rule_info(rule).operation);
}

/// The inputs that are always there, and names that the skeleton of another input would have.
std::regex reserved_names() {
  std::vector<std::string> names;
  for (const Rule rule : measured_rules()) names.push_back(name_of(rule));
  return std::regex("scene|blobs|.*_(" + joined(names, "|") + ")");
}

struct Thinned {
  ByteImage skeleton;
  int iterations;
};

Thinned thinned(Rule rule, const ConstImageView& image) {
  Thinned result{ByteImage(image.width, image.height), 0};
  result.iterations = thin(rule, image, result.skeleton.view());
  return result;
}

ByteImage rotated(const ConstImageView& image, int quarters) {
  ByteImage result = copy_of(image);
  for (int turn = 0; turn < quarters; ++turn) result = rotated_by_quarter(result.view());
  return result;
}

/// With the skeletons of the image rotated by one, two and three quarters, each rotated back.
double min_overlap(Rule rule, const ConstImageView& image, const ConstImageView& skeleton) {
  double least = 1;
  for (int quarters = 1; quarters < 4; ++quarters) {
    const ByteImage other = thinned(rule, rotated(image, quarters).view()).skeleton;
    least = std::min(least, overlap(skeleton, rotated(other.view(), 4 - quarters).view()));
  }
  return least;
}

QualityRow measure(Rule rule, const QualityInput& input, const Topology& before,
                   const ByteImage& axis) {
  const ConstImageView image = input.image.view();
  const Thinned result = thinned(rule, image);
  const ConstImageView skeleton = result.skeleton.view();
  return {name_of(rule),
          input.name,
          before,
          topology_of(skeleton),
          shape_of(skeleton),
          distance_from(axis.view(), skeleton),
          min_overlap(rule, image, skeleton),
          result.iterations};
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

nlohmann::ordered_json json_of(const QualityRow& row) {
  return {{"operation", row.operation},
          {"border", border_name(Border::background)},
          {"max_iterations", nullptr},
          {"input", row.input},
          {"objects_before", row.before.objects},
          {"objects_after", row.after.objects},
          {"holes_before", row.before.holes},
          {"holes_after", row.after.holes},
          {"pixels", row.shape.pixels},
          {"blocks", row.shape.blocks},
          {"ends", row.shape.ends},
          {"branches", row.shape.branches},
          {"mean_distance", row.from_axis.mean},
          {"largest_distance", row.from_axis.largest},
          {"least_symmetry", row.least_symmetry},
          {"iterations", row.iterations}};
}

std::vector<std::string> cells_of(const QualityRow& row) {
  const auto change = [](Index before, Index after) {
    return std::to_string(before) + " to " + std::to_string(after);
  };
  return {row.input,
          row.operation,
          change(row.before.objects, row.after.objects),
          change(row.before.holes, row.after.holes),
          std::to_string(row.shape.pixels),
          std::to_string(row.shape.blocks),
          std::to_string(row.shape.ends),
          std::to_string(row.shape.branches),
          fixed(row.from_axis.mean, 3),
          fixed(row.from_axis.largest, 2),
          fixed(row.least_symmetry, 3),
          std::to_string(row.iterations)};
}

}  // namespace

ByteImage blobs(Index width, Index height, std::uint64_t seed) {
  constexpr int most = (2 * kBlobReach + 1) * (2 * kBlobReach + 1) / 2;
  const ByteImage noise = noise_image(width, height, 50, 1, seed);
  ByteImage result(width, height);
  for (Index y = 0; y < height; ++y) {
    for (Index x = 0; x < width; ++x) {
      result.at(x, y) = foreground_round(noise, x, y) > most ? 255 : 0;
    }
  }
  return result;
}

std::vector<QualityInput> quality_inputs(const std::vector<std::string>& pictures,
                                         const BinariseOptions& binarise, std::ostream* log) {
  std::vector<QualityInput> inputs;
  inputs.push_back({"scene", std::move(render_scene().binary)});
  inputs.push_back({"blobs", blobs(kBlobSide, kBlobSide, 1)});
  const std::regex reserved = reserved_names();
  for (const std::string& path : pictures) {
    inputs.push_back(
        {picture_name(path, names_of(inputs), reserved), read_binary(path, binarise, log)});
  }
  return inputs;
}

std::vector<QualityRow> run_thinning_quality(const std::vector<QualityInput>& inputs) {
  std::vector<QualityRow> rows;
  for (const QualityInput& input : inputs) {
    const Topology before = topology_of(input.image.view());
    const ByteImage axis = medial_axis_of(input.image.view());
    for (const Rule rule : measured_rules()) {
      rows.push_back(measure(rule, input, before, axis));
    }
  }
  return rows;
}

void write_skeletons(const std::string& folder, const std::vector<QualityInput>& inputs) {
  for (const QualityInput& input : inputs) {
    const std::string stem = folder + "/quality_" + input.name;
    write_grey(stem + ".png", input.image.view());
    for (const Rule rule : measured_rules()) {
      write_grey(stem + "_" + name_of(rule) + ".png",
                 thinned(rule, input.image.view()).skeleton.view());
    }
  }
}

ExperimentReport thinning_quality_report(const std::vector<QualityRow>& rows,
                                         const std::string& options) {
  nlohmann::ordered_json json = {{"rows", nlohmann::ordered_json::array()}};
  std::vector<std::vector<std::string>> cells;
  for (const QualityRow& row : rows) {
    json["rows"].push_back(json_of(row));
    cells.push_back(cells_of(row));
  }
  return {
      experiment_json("quality", json, options),
      "Skeletons. Distances are from the ridge of the exact distance map, in pixels; least "
      "symmetry is the smallest overlap with the skeletons of the input rotated by 90, 180 and "
      "270 degrees:\n\n" +
          markdown_table({"Input", "Operation", "Objects", "Holes", "Pixels", "2x2 blocks", "Ends",
                          "Branches", "Mean distance", "Largest", "Least symmetry", "Iterations"},
                         cells)};
}

}  // namespace thinbench
