#include "catalog.hpp"

#include <array>

#include "regions/holes_rows.hpp"
#include "nets/net_rows.hpp"
#include "midpoints/scan_rows.hpp"
#include "thinning/rule_rows.hpp"
#include "thinning/engines/spta.hpp"

namespace thinbench {
namespace {

template <class Rule>
ThinningOperation thinning(std::string_view name, std::string_view description) {
  ThinningOperation operation{name, description, rows_of<Rule>()};
  operation.lane_kernels = &lane_kernels_of<Rule>();
  return operation;
}

template <class Rule>
ThinningOperation border_keeping(std::string_view name, std::string_view description) {
  ThinningOperation operation{name, description, border_keeping_rows_of<Rule>()};
  operation.border = Border::keep;
  operation.lane_kernels = &lane_kernels_of<Rule>();
  return operation;
}

ThinningOperation scan(std::string_view name, std::string_view description,
                       std::span<const ThinningVariant> rows) {
  ThinningOperation operation{name, description, rows};
  operation.max_iterations = 1;
  operation.takes_directions = true;
  return operation;
}

constexpr std::array kSequentialSptaRows = {
    ThinningVariant{Technique::lut, Isa::baseline, kOneThread, kAnyWidth, &SptaKernels::kLut},
    ThinningVariant{Technique::bitpacked, Isa::baseline, kOneThread, kAnyWidth,
                    &SptaKernels::kBitpacked},
};

}  // namespace

std::span<const ThinningOperation> thinning_operations() {
  static const std::array operations = {
      thinning<NaccacheShinghal>(
          "thin_naccache_shinghal",
          "modified Naccache-Shinghal rule, all removals of a pass at once, as printed"),
      thinning<ZhangSuen>("thin_zhang_suen", "Zhang and Suen 1984, two sub-iterations"),
      border_keeping<ZhangSuen>("thin_zhang_suen_keep_border",
                                "the same, equal to OpenCV's on every image"),
      thinning<GuoHall>("thin_guo_hall", "Guo and Hall 1989, two sub-iterations; keeps topology"),
      border_keeping<GuoHall>("thin_guo_hall_keep_border",
                              "the same, equal to OpenCV's on every image"),
      ThinningOperation{"thin_spta",
                        "Naccache and Shinghal's SPTA as published, two sequential scans a pass: "
                        "rows depend on each other, so no threads; keeps topology",
                        kSequentialSptaRows},
      thinning<SptaDirectional>(
          "thin_spta_directional",
          "Naccache and Shinghal's SPTA, one direction after another; keeps topology"),
      thinning<Mb2>("thin_mb2",
                    "Bernard and Manzanera 1999, fully parallel, 5 x 5; keeps topology"),
      scan("skeleton_scan",
           "the paper's own method: centres of dark runs along rows, columns and both diagonals",
           scan_rows()),
      ThinningOperation{"net_two_layer_sigmoid",
                        "thinning by the two-layer net of Table 1, sigmoid (1); hidden values "
                        "across lanes agree within 2 units in the last place, outputs within 9",
                        net_rows(NetKind::sigmoid), &paper_sigmoid_model},
      ThinningOperation{"net_two_layer_sigmoid_pass", "one pass of net_two_layer_sigmoid",
                        net_rows(NetKind::sigmoid), &paper_sigmoid_model, 1},
      ThinningOperation{
          "net_two_layer_rounded",
          "net_two_layer_sigmoid with weights rounded to integers: not quite the rule",
          net_rows(NetKind::sigmoid), &rounded_sigmoid_model},
      ThinningOperation{"net_two_layer_linear",
                        "thinning by the two-layer net of Table 1, linear threshold (2); all "
                        "values agree bit for bit",
                        net_rows(NetKind::linear), &paper_linear_model},
      ThinningOperation{"net_two_layer_linear_pass", "one pass of net_two_layer_linear",
                        net_rows(NetKind::linear), &paper_linear_model, 1},
      ThinningOperation{"net_single_layer_cluster",
                        "thinning by the cluster of twelve single-layer nets (5) to (7)",
                        net_rows(NetKind::cluster), &trained_cluster_model},
      ThinningOperation{"net_single_layer_cluster_pass", "one pass of net_single_layer_cluster",
                        net_rows(NetKind::cluster), &trained_cluster_model, 1},
  };
  return operations;
}

std::span<const EdgeOperation> edge_operations() {
  const auto operation = [](std::string_view name, std::string_view description, EdgeOperator op) {
    return EdgeOperation{name, description, op, edge_rows(op)};
  };
  static const std::array operations = {
      operation("edges_roberts4", "edges by Roberts' cross of 2 x 2 pixels",
                EdgeOperator::roberts4),
      operation("edges_roberts9", "edges by the corner cross of the 3 x 3 window",
                EdgeOperator::roberts9),
      operation("edges_mero_vassy", "edges by Mero and Vassy's split window, 3 x 3",
                EdgeOperator::mero_vassy),
      operation("edges_mero_vassy_5x5", "edges by Mero and Vassy's split window, 5 x 5",
                EdgeOperator::mero_vassy_5x5),
      operation("edges_sobel", "edges by Sobel's operator", EdgeOperator::sobel),
      operation("edges_prewitt", "edges by Prewitt's operator", EdgeOperator::prewitt),
  };
  return operations;
}

const ThinningOperation* find_thinning_operation(std::string_view name) {
  for (const ThinningOperation& operation : thinning_operations()) {
    if (operation.name == name) return &operation;
  }
  return nullptr;
}

std::span<const HolesOperation> holes_operations() {
  static const std::array operations = {
      HolesOperation{"holes", "objects (8-connected) and their holes, with areas and centres",
                     HolesTask::holes, region_rows()},
      HolesOperation{"components", "objects (8-connected) alone, with areas and centres",
                     HolesTask::components, region_rows()},
      HolesOperation{"fill_holes", "objects with all that they enclose, interior contours filled",
                     HolesTask::fill, fill_rows()},
      HolesOperation{"euler_number", "8-connected objects minus 4-connected holes",
                     HolesTask::euler_eight, euler_rows()},
      HolesOperation{"euler_number_4", "4-connected objects minus 8-connected holes",
                     HolesTask::euler_four, euler_rows()},
  };
  return operations;
}

const LocaliseOperation& localise_operation() {
  static const LocaliseOperation operation = {
      "localise_objects",
      "grey picture to Sobel's edges, contours, filled interiors and centres of objects and holes",
      localise_rows()};
  return operation;
}

const EdgeOperation* find_edge_operation(std::string_view name) {
  for (const EdgeOperation& operation : edge_operations()) {
    if (operation.name == name) return &operation;
  }
  return nullptr;
}

const HolesOperation* find_holes_operation(std::string_view name) {
  for (const HolesOperation& operation : holes_operations()) {
    if (operation.name == name) return &operation;
  }
  return nullptr;
}

}  // namespace thinbench
