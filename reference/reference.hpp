// The paper in plain code: one short function per operation, obviously correct, never tuned. It
// shares data types with the kernels (views of images, options, weights of nets) and no code that
// computes.
#pragma once

#include <string_view>

#include "thinbench/edges.hpp"
#include "thinbench/image_view.hpp"
#include "thinbench/nets.hpp"
#include "thinbench/options.hpp"
#include "thinbench/rule.hpp"

namespace thinbench::reference {

/// How often to repeat, and what to do at the border.
struct Repetition {
  Border border = Border::background;
  int max_iterations = kUnlimited;
};

/// Thinning by a rule, each in a file of its own:
///
/// naccache_shinghal: the modified rule of section 3.1, exactly as published. For each foreground
/// pixel four expressions over its eight neighbours are calculated (n0 = east, then anticlockwise,
/// foreground is TRUE):
///   B4 = n0 (n1 + n2 + n6 + n7) (n2 + !n3) (!n5 + n6)    left edge points
///   B0 = n4 (n2 + n3 + n5 + n6) (n6 + !n7) (!n1 + n2)    right edge points
///   B2 = n6 (n0 + n4 + n5 + n7) (n0 + !n1) (!n3 + n4)    top edge points
///   B6 = n2 (n0 + n1 + n3 + n4) (n4 + !n5) (!n7 + n0)    bottom edge points
/// If one or two of them are FALSE the pixel becomes background in a second matrix, else it is
/// copied. The second matrix then becomes the image, until an iteration changes nothing. Topology
/// is not kept.
///
/// zhang_suen (CACM 27(3), 1984): two sub-iterations. The neighbours p2 ... p9 go clockwise from
/// the north; a is the number of steps from background to foreground on the way round, b that of
/// foreground neighbours. Equal to OpenCV's THINNING_ZHANGSUEN where the border is kept.
///
/// guo_hall (CACM 32(3), 1989): algorithm A1. Equal to OpenCV's THINNING_GUOHALL where the border
/// is kept.
///
/// spta (Naccache and Shinghal, IEEE SMC 14(3), 1984): sequential. An iteration is two scans in
/// raster order: left and right edge points first, then top and bottom ones. A foreground pixel is
/// flagged where it is an edge point of a side whose expression (above) is TRUE; there unprimed
/// literals read "foreground and not yet flagged", the edge test and primed literals "background
/// before the iteration". Flagged pixels become background after the iteration. Keeps topology, is
/// idempotent.
///
/// spta_directional: the same in four parallel sub-iterations: left, right, top and bottom edge
/// points whose expression is TRUE are removed, each side on the result of the one before.
///
/// mb2 (Bernard and Manzanera 1999): fully parallel, support 5 x 5. I is a foreground pixel with
/// four foreground 4-neighbours; a1: I on one side and background opposite; a2: I on a diagonal and
/// the two opposite 4-neighbours background; b: a foreground diagonal between two background
/// 4-neighbours. Removed where (a1 or a2) and not b.
///
/// midpoint_scan: as below, along all directions.
///
/// net_*: as below, with the weights of Table 1 or, for the cluster, the trained ones.
///
/// Outside the image everything is background; with Border::keep the outermost pixels never change.
/// `source`: 0 is background, anything else foreground; `destination`: 0 and 255, same size, may be
/// the source. Returns the number of iterations, the last, which changed nothing, included.
template <Rule rule>
int thin(const Repetition& repetition, ConstImageView source, ImageView destination);

using Thinning = int (*)(const Repetition& repetition, ConstImageView source,
                         ImageView destination);

/// The reference of a rule chosen at run time.
[[nodiscard]] Thinning thinning(Rule rule);

/// The paper's own method, end of section 3.1: the image is scanned along each of `directions`, and
/// the midpoint of every run of foreground pixels, p[first ... last], is marked:
///   midpoint = first + floor((last - first) / 2)
/// The paper says "marking the centre point of the object segment" and no more. Chosen here: of the
/// two middle pixels of an even run the first in the order of the scan (the western one in rows,
/// else the northern one); a single pixel is the midpoint of itself, so that lines one pixel wide
/// stay whole; outside the image everything is background, so that the border ends a run. The
/// result is the union of all marks; with Border::keep the outermost pixels are those of the
/// source.
///
/// Views as above; returns 1, there is one iteration. The result is a subset of the image with at
/// least one pixel of every 8-component. It is neither connected nor thin in general, and not
/// idempotent: it keeps no topology.
int midpoint_scan(Directions directions, Border border, ConstImageView source,
                  ImageView destination);

/// Thinning by the two-layer net of section 3.2: the published procedure, but a foreground pixel is
/// kept where the net says 0.5 or more, equations (3) and (4) with activation (1) or (2). Single
/// precision; sums start with the bias and go from input 0 to input 7.
int net_two_layer(const TwoLayerWeights& net, Activation activation, const Repetition& repetition,
                  ConstImageView source, ImageView destination);

/// Thinning by the cluster of single-layer nets of section 3.3: the descriptor (5) picks the net,
/// (6) and (7) decide; otherwise as net_two_layer.
int net_single_layer_cluster(const ClusterWeights& cluster, const Repetition& repetition,
                             ConstImageView source, ImageView destination);

/// The output of the two-layer net before the step (4), for eight inputs.
[[nodiscard]] float two_layer_answer(const TwoLayerWeights& net, Activation activation,
                                     const float* inputs);

/// Equation (1) or (2).
[[nodiscard]] float activation_answer(Activation activation, float x);

/// Edges by steps a) to d) of section 2.1: `destination` is 255 where the scaled gradient is bigger
/// than the gradient threshold and the brightest pixel of the 3 x 3 neighbourhood is bigger than
/// the brightness threshold, else 0.
///
/// The magnitude is |gx| + |gy|, an integer, compared with the threshold times the operator's
/// scale, by which a vertical step of height h reads h, so that nothing is rounded. Border: edge
/// replication. `source` and `destination` have one size and do not overlap.
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

}  // namespace thinbench::reference
