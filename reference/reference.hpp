// The paper in plain code: one short function per operation, obviously correct, never tuned. Shares
// data types with the kernels (image views, options, weights of nets), but no computation.
#pragma once

#include <span>
#include <string_view>

#include "thinbench/distance.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/image_view.hpp"
#include "thinbench/midpoint_scan.hpp"
#include "thinbench/nets.hpp"
#include "thinbench/options.hpp"
#include "thinbench/rule.hpp"
#include "thinbench/window_table.hpp"

namespace thinbench::reference {

struct Repetition {
  Border border = Border::background;
  int max_iterations = kUnlimited;
};

/// Thinning by a rule, one file per rule:
///
/// naccache_shinghal: the modified rule of section 3.1, exactly as published. Each foreground pixel
/// has four expressions over its eight neighbours (n0 = east, then anticlockwise, foreground is
/// TRUE):
///   B4 = n0 (n1 + n2 + n6 + n7) (n2 + !n3) (!n5 + n6)    left edge points
///   B0 = n4 (n2 + n3 + n5 + n6) (n6 + !n7) (!n1 + n2)    right edge points
///   B2 = n6 (n0 + n4 + n5 + n7) (n0 + !n1) (!n3 + n4)    top edge points
///   B6 = n2 (n0 + n1 + n3 + n4) (n4 + !n5) (!n7 + n0)    bottom edge points
/// If one or two of them are FALSE, the pixel is background in a second matrix, else it is copied.
/// The second matrix then becomes the image, until an iteration changes nothing. Does not keep
/// topology.
///
/// zhang_suen (CACM 27(3), 1984): two sub-iterations. The neighbours p2 ... p9 go clockwise from
/// the north; a is the number of transitions from background to foreground around the pixel, b that
/// of foreground neighbours. Equal to OpenCV's THINNING_ZHANGSUEN where the border is kept.
///
/// guo_hall (CACM 32(3), 1989): algorithm A1. Equal to OpenCV's THINNING_GUOHALL where the border
/// is kept.
///
/// spta_directional: Naccache and Shinghal's SPTA, see spta() below, in four parallel
/// sub-iterations, which remove left, right, top and bottom edge points with a TRUE expression,
/// each from the result of the one before.
///
/// mb2 (Bernard and Manzanera 1999): fully parallel, support 5 x 5. I is a foreground pixel with
/// four foreground 4-neighbours; a1: I on one side and background opposite; a2: I on a diagonal and
/// the two opposite 4-neighbours background; b: a foreground diagonal between two background
/// 4-neighbours. Removed where (a1 or a2) and not b.
///
/// Outside the image everything is background; with Border::keep the outermost pixels never change.
/// `source`: 0 is background, anything else foreground; `destination`: 0 and 255, same size, may be
/// the source. Returns the number of iterations, including the last, which changed nothing.
template <BuiltInRule rule>
int thin(const Repetition& repetition, ConstImageView source, ImageView destination);

using Thinning = int (*)(const Repetition& repetition, ConstImageView source,
                         ImageView destination);

/// The reference of a rule chosen at run time.
[[nodiscard]] Thinning thinning(BuiltInRule rule);

/// SPTA (Naccache and Shinghal, IEEE SMC 14(3), 1984): sequential. An iteration is two scans in
/// raster order: left and right edge points first, then top and bottom ones. A foreground pixel is
/// flagged where it is an edge point of a side with a TRUE expression (above). Unprimed literals
/// read "foreground and not yet flagged", the edge test and primed literals "background before the
/// iteration". Flagged pixels become background after the iteration. Keeps topology, idempotent.
int spta(const Repetition& repetition, ConstImageView source, ImageView destination);

/// A rule given as tables, one per sub-iteration: the new value of every pixel is the table's bit
/// for the pixel's 3 x 3 window, which may add pixels. An iteration changes nothing if none of its
/// sub-iterations changed a pixel. With Border::foreground everything outside the image is
/// foreground, otherwise background; limit, views and result as above.
int apply_tables(std::span<const WindowTable> sub_iterations, const Repetition& repetition,
                 ConstImageView source, ImageView destination);

/// The paper's own method, end of section 3.1: scans the image along each of `directions` and marks
/// the midpoint of every run of foreground pixels, p[first ... last]:
///   midpoint = first + floor((last - first) / 2)
/// The paper only says "marking the centre point of the object segment". Our choices: of the two
/// middle pixels of an even run, the first in scan order (the western one in rows, else the
/// northern one); a single pixel is its own midpoint, so lines one pixel wide are kept; everything
/// outside the image is background, so the border ends a run. The result is the union of all marks;
/// with Border::keep the outermost pixels are those of the source.
///
/// Views as above; returns 1, the number of iterations. The result is a subset of the image with at
/// least one pixel of every 8-component. In general it is not connected, thin or idempotent, and
/// topology is not kept.
int midpoint_scan(Directions directions, Border border, ConstImageView source,
                  ImageView destination);

/// Thinning by the two-layer net of section 3.2: the published procedure, but a foreground pixel is
/// kept where the output is 0.5 or more, equations (3) and (4) with activation (1) or (2). Single
/// precision; sums start with the bias and go from input 0 to input 7.
int net_two_layer(const TwoLayerWeights& net, Activation activation, const Repetition& repetition,
                  ConstImageView source, ImageView destination);

/// Thinning by the cluster of single-layer nets of section 3.3: the descriptor (5) selects the net,
/// (6) and (7) decide; otherwise as net_two_layer.
int net_single_layer_cluster(const ClusterWeights& cluster, const Repetition& repetition,
                             ConstImageView source, ImageView destination);

/// The output of the two-layer net before equation (4), for eight inputs.
[[nodiscard]] float two_layer_output(const TwoLayerWeights& net, Activation activation,
                                     const float* inputs);

/// Equation (1) or (2).
[[nodiscard]] float activation_output(Activation activation, float x);

/// Edges by steps a) to d) of section 2.1: `destination` is 255 where the scaled gradient exceeds
/// the gradient threshold and the brightest pixel of the 3 x 3 neighbourhood exceeds the brightness
/// threshold, else 0.
///
/// The magnitude |gx| + |gy| is compared with the threshold times the operator's scale, so that the
/// scaled gradient of a vertical step edge is its height. Exact integer arithmetic. Border: edge
/// replication. `source` and `destination` must have the same size and must not overlap.
using EdgeDetection = void (*)(const EdgeThresholds& thresholds, ConstImageView source,
                               ImageView destination);

/// The reference of an edge operator:
///   roberts4        f(x,y) - f(x+1,y+1), f(x+1,y) - f(x,y+1); scale 2
///   roberts9        NW - SE, NE - SW; scale 2
///   prewitt         weights 1 1 1 across the direction; scale 3
///   sobel           weights 1 2 1; scale 4
///   mero_vassy      the window split by either diagonal; scale 4
///   mero_vassy_5x5  the same in a window of 5 x 5; scale 12
[[nodiscard]] EdgeDetection edges(EdgeOperator op);

/// The squared distance of every pixel to the nearest background pixel: distances along columns
/// first, then the minimum of all columns, (x - u)^2 + distance(u, y)^2. kNoBackground everywhere
/// in an image without background.
void squared_distances(ConstImageView source, LabelView distances);
/// The same with a spacing: the formula of thinbench/distance.hpp for every pair of pixels.
void distances(ConstImageView source, View<double> distances, const Spacing& spacing);

}  // namespace thinbench::reference
