// Edges in one header: detect them in a picture, let the library choose how.
#pragma once

#include <string_view>

#include "catalog.hpp"
#include "image/byte_image.hpp"
#include "edges/plan.hpp"

namespace thinbench {

/// The variant that fits the wish. Throws std::invalid_argument, naming what is wrong and what
/// there is instead, where none does.
[[nodiscard]] const EdgeVariant& choose_variant(const EdgeOperation& operation, Index width,
                                                const VariantRequest& wish = {});

/// Writes the edges of `source` by the operation of this name to `destination`: 255 where
///   |gx| + |gy| > scale * p1   and   the brightest pixel of the 3 x 3 neighbourhood > p2,
/// else 0. The scale is the operator's own: a vertical step of height h reads h (Roberts 2, Prewitt
/// 3, Sobel and Mero-Vassy 4, Mero-Vassy in 5 x 5 pixels 12). All in integers, nothing is rounded.
///
/// gx and gy, by rows of the window ("/" between them):
///   roberts4     1 0 / 0 -1               and  0 1 / -1 0, the pixel at the upper left
///   roberts9     1 0 0 / 0 0 0 / 0 0 -1   and  0 0 1 / 0 0 0 / -1 0 0
///   prewitt      -1 0 1 / -1 0 1 / -1 0 1 and  -1 -1 -1 / 0 0 0 / 1 1 1
///   sobel        -1 0 1 / -2 0 2 / -1 0 1 and  -1 -2 -1 / 0 0 0 / 1 2 1
///   mero_vassy   0 1 1 / -1 0 1 / -1 -1 0 and  -1 -1 0 / -1 0 1 / 0 1 1; in 5 x 5 pixels likewise
///                the right less the left side of the falling and of the rising diagonal
/// The paper names its operators and prints no masks. Chosen here: |gx| + |gy| as the magnitude;
/// the corners of the window for Roberts' 9 points, of which there is no standard; and the split
/// along both diagonals, as no text that quotes Mero and Vassy's masks was found.
///
/// Outside the image its outermost pixels go on, so that no edge arises at the frame by itself.
/// Grey levels are as files hold them, 255 for white, and p2 asks for a bright background beside
/// the edge: invert pictures of bright parts on dark ground first. Strides are bytes from row to
/// row and may be larger than the width. The two views have one size and do not overlap.
///
/// Not known to hold: that contours are closed or one pixel wide; at a step they are two pixels
/// wide or more, but for roberts4. Throws std::invalid_argument for an unknown name, a threshold
/// outside [0, 255], sizes that differ or are negative, a stride below the width, a null image, an
/// overlap, or a wish that no variant fits. Source: section 2.1 of the paper, steps a) to d).
void detect_edges(std::string_view operation, ConstImageView source, ImageView destination,
                  const EdgeThresholds& thresholds = {}, const VariantRequest& wish = {});

}  // namespace thinbench
