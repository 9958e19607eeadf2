// Edges of grey images: section 2.1 of the paper.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "thinbench/enumeration.hpp"
#include "thinbench/export.h"
#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"

namespace thinbench {

enum class EdgeOperator : std::uint8_t {
  roberts4,
  roberts9,
  mero_vassy,
  mero_vassy_5x5,
  sobel,
  prewitt,
};

struct EdgeOperatorInfo {
  EdgeOperator op;
  std::string_view name;
  std::string_view operation;  // its name as an operation, for example in results
  std::string_view description;
};

/// In the order of the enumeration.
inline constexpr std::array kEdgeOperators = {
    EdgeOperatorInfo{EdgeOperator::roberts4, "roberts4", "edges_roberts4",
                     "edges by Roberts' cross of 2 x 2 pixels"},
    EdgeOperatorInfo{EdgeOperator::roberts9, "roberts9", "edges_roberts9",
                     "edges by the corner cross of the 3 x 3 window"},
    EdgeOperatorInfo{EdgeOperator::mero_vassy, "mero_vassy", "edges_mero_vassy",
                     "edges by Mero and Vassy's split window, 3 x 3"},
    EdgeOperatorInfo{EdgeOperator::mero_vassy_5x5, "mero_vassy_5x5", "edges_mero_vassy_5x5",
                     "edges by Mero and Vassy's split window, 5 x 5"},
    EdgeOperatorInfo{EdgeOperator::sobel, "sobel", "edges_sobel", "edges by Sobel's operator"},
    EdgeOperatorInfo{EdgeOperator::prewitt, "prewitt", "edges_prewitt",
                     "edges by Prewitt's operator"},
};

/// Throws std::invalid_argument for a value outside the enumeration.
[[nodiscard]] constexpr const EdgeOperatorInfo& edge_operator_info(EdgeOperator op) {
  return detail::entry_of(kEdgeOperators, op, "operator");
}

/// The operator of this name, or of the operation of this name.
[[nodiscard]] constexpr std::optional<EdgeOperator> edge_operator_from_name(std::string_view name) {
  for (const EdgeOperatorInfo& info : kEdgeOperators) {
    if (info.name == name || info.operation == name) return info.op;
  }
  return std::nullopt;
}

/// Thresholds in grey levels, 0 to 255. An edge has a scaled gradient above `gradient_threshold`
/// and a pixel above `brightness_threshold` in its 3 x 3 neighbourhood; the background is bright.
struct EdgeThresholds {
  int gradient_threshold = 40;     // P1 of the paper
  int brightness_threshold = 128;  // P2 of the paper
};

inline constexpr int kMaxThreshold = 255;

/// Writes the edges of `source` to `destination`: 255 where
///   |gx| + |gy| > scale * gradient_threshold   and
///   the maximum of the 3 x 3 neighbourhood > brightness_threshold,
/// else 0. The scale makes the scaled gradient of a vertical step edge equal to its height: Roberts
/// 2, Prewitt 3, Sobel and Mero-Vassy 4, Mero-Vassy 5 x 5 12. Exact integer arithmetic.
///
/// gx and gy, by rows of the window, separated by "/":
///   roberts4     1 0 / 0 -1               and  0 1 / -1 0, with the pixel at the upper left
///   roberts9     1 0 0 / 0 0 0 / 0 0 -1   and  0 0 1 / 0 0 0 / -1 0 0
///   prewitt      -1 0 1 / -1 0 1 / -1 0 1 and  -1 -1 -1 / 0 0 0 / 1 1 1
///   sobel        -1 0 1 / -2 0 2 / -1 0 1 and  -1 -2 -1 / 0 0 0 / 1 2 1
///   mero_vassy   0 1 1 / -1 0 1 / -1 -1 0 and  -1 -1 0 / -1 0 1 / 0 1 1; likewise for 5 x 5: the
///                right minus the left side of the falling and of the rising diagonal
/// The paper names its operators but publishes no masks. Our choices: |gx| + |gy| as the magnitude;
/// the corners of the window for Roberts' 9 points, for which there is no standard; and the split
/// along both diagonals, as we found no source that quotes Mero and Vassy's masks.
///
/// Border: edge replication, so the border itself is no edge. White is 255. The brightness
/// threshold requires a bright background next to the edge, so invert images of bright objects on a
/// dark background first. Both views must have the same size and must not overlap.
///
/// Thread-safe for different destinations. Throws std::invalid_argument for a threshold outside [0,
/// 255], sizes that differ or are negative, a stride below the width, a null image, an overlap,
/// threads out of range, or an ISA that is not available, and std::bad_alloc if memory runs out.
/// Nothing is written if it throws.
///
/// Not guaranteed: contours that are closed or one pixel wide. At a step edge they are at least two
/// pixels wide, except with roberts4. Source: section 2.1 of the paper, steps a) to d).
THINBENCH_API void detect_edges(EdgeOperator op, ConstImageView source, ImageView destination,
                                const EdgeThresholds& thresholds = {},
                                const Execution& execution = {});

}  // namespace thinbench
