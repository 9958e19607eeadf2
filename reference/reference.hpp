// The paper in plain code: one short function per operation, obviously right, never tuned. It
// shares data types with the kernels (views of images, weights of nets) and no code that computes.
#pragma once

#include <string_view>

#include "image/plane_view.hpp"
#include "nets/weights.hpp"
#include "midpoints/directions.hpp"
#include "thinning/border.hpp"

namespace thinbench::reference {

/// Thinning by the modified Naccache-Shinghal rule, section 3.1 of the paper, exactly as printed.
///
/// For each dark pixel four expressions over its eight neighbours are calculated (n0 = east, then
/// anticlockwise, dark is TRUE):
///   B4 = n0 (n1 + n2 + n6 + n7) (n2 + !n3) (!n5 + n6)    left edge points
///   B0 = n4 (n2 + n3 + n5 + n6) (n6 + !n7) (!n1 + n2)    right edge points
///   B2 = n6 (n0 + n4 + n5 + n7) (n0 + !n1) (!n3 + n4)    top edge points
///   B6 = n2 (n0 + n1 + n3 + n4) (n4 + !n5) (!n7 + n0)    bottom edge points
/// If one or two of them are FALSE the pixel becomes light in a second matrix, else it is copied.
/// The second matrix then becomes the image, until a scan changes nothing.
///
/// Outside the image everything is light. `source`: 0 is light, anything else dark; `destination`:
/// 0 and 255, same size, may be the source. Returns the number of scans, the last, which changed
/// nothing, included. Topology is not kept: see kernels/thinning/rules/naccache_shinghal.hpp.
int thin_naccache_shinghal(ConstImageView source, ImageView destination);

/// Zhang and Suen's thinning (CACM 27(3), 1984): two sub-iterations a cycle. The neighbours p2 ...
/// p9 go clockwise from the north; a is the number of steps from light to dark on the way round, b
/// that of dark neighbours. Equal to OpenCV's THINNING_ZHANGSUEN where the border is kept. Returns
/// the number of cycles, the last, which changed nothing, included; otherwise as above.
int thin_zhang_suen(Border border, ConstImageView source, ImageView destination);

/// Guo and Hall's thinning (CACM 32(3), 1989), algorithm A1, in the same form. Equal to OpenCV's
/// THINNING_GUOHALL where the border is kept.
int thin_guo_hall(Border border, ConstImageView source, ImageView destination);

/// Naccache and Shinghal's SPTA in four parallel sub-iterations: left, right, top and bottom edge
/// points whose expression (above) is TRUE are removed, each side on the result of the one before.
int thin_spta_directional(Border border, ConstImageView source, ImageView destination);

/// Naccache and Shinghal's SPTA as published (IEEE SMC 14(3), 1984), sequential. A pass is two
/// scans in raster order: left and right edge points first, then top and bottom ones. A dark pixel
/// is flagged where it is an edge point of a side whose expression (above) is TRUE; there unprimed
/// literals read "dark and not yet flagged", the edge test and primed literals "light before the
/// pass". Flagged pixels become light after the pass; a pass that flags nothing is the last, and
/// counts. Outside the image everything is light. Keeps topology, is idempotent.
int thin_spta(ConstImageView source, ImageView destination);

/// Bernard and Manzanera's MB2 (1999), fully parallel, support 5 x 5: I is a dark pixel with four
/// dark 4-neighbours; a1: I on one side and light opposite; a2: I on a diagonal and the two
/// opposite 4-neighbours light; b: a dark diagonal between two light 4-neighbours. Removed where
/// (a1 or a2) and not b.
int thin_mb2(Border border, ConstImageView source, ImageView destination);

/// The paper's own method, end of section 3.1: the image is scanned along each of `directions`, and
/// the centre of every run of dark pixels, p[first ... last], is marked:
///   centre = first + floor((last - first) / 2)
/// The paper says "marking the centre point of the object segment" and no more. Chosen here: of the
/// two middle pixels of an even run the first in the order of the scan (the western one in rows,
/// else the northern one); a single pixel is the centre of itself, so that lines one pixel wide
/// stay whole; outside the image everything is light, so that the frame ends a run. The result is
/// the union of all marks.
///
/// Views as above; returns 1, there is one pass. The result is a subset of the image with at least
/// one pixel of every 8-component. It is neither connected nor thin in general, and not
/// idempotent: it keeps no topology.
int skeleton_scan(Directions directions, ConstImageView source, ImageView destination);

/// Thinning by the two-layer net of section 3.2: passes and stop rule as above, but a dark pixel
/// stays where the net says 0.5 or more, equations (3) and (4) with activation (1) or (2). Single
/// precision; sums start with the bias and go from input 0 to input 7. Ends after `max_iterations` at
/// the latest.
int net_two_layer(const TwoLayerWeights& net, Activation activation, int max_iterations,
                  ConstImageView source, ImageView destination);

/// Thinning by the cluster of single-layer nets of section 3.3: the descriptor (5) picks the net,
/// (6) and (7) decide; otherwise as net_two_layer.
int net_single_layer_cluster(const ClusterWeights& cluster, int max_iterations, ConstImageView source,
                             ImageView destination);

/// The output of the two-layer net before the step (4), for eight inputs.
[[nodiscard]] float two_layer_answer(const TwoLayerWeights& net, Activation activation,
                                     const float* inputs);

/// Equation (1) or (2).
[[nodiscard]] float activation_answer(Activation activation, float x);

/// Edges by steps a) to d) of section 2.1: `destination` is 255 where the scaled gradient is bigger
/// than `p1` and the brightest pixel of the 3 x 3 neighbourhood is bigger than `p2`, else 0.
///
/// The magnitude is |gx| + |gy|, an integer, compared with p1 times the operator's scale, by which
/// a vertical step of height h reads h, so that nothing is rounded. Outside the image the outermost
/// pixels go on. `source` and `destination` have one size and do not overlap.
using EdgeDetection = void (*)(int p1, int p2, ConstImageView source, ImageView destination);

/// The reference of the edge operation of this name, or nullptr:
///   edges_roberts4        f(x,y) - f(x+1,y+1), f(x+1,y) - f(x,y+1); scale 2
///   edges_roberts9        NW - SE, NE - SW; scale 2
///   edges_prewitt         weights 1 1 1 across the direction; scale 3
///   edges_sobel           weights 1 2 1; scale 4
///   edges_mero_vassy      the window split by either diagonal; scale 4
///   edges_mero_vassy_5x5  the same in a window of 5 x 5; scale 12
[[nodiscard]] EdgeDetection find_edges(std::string_view operation);

using Thinning = int (*)(ConstImageView source, ImageView destination);

/// The reference of the thinning operation of this name, or nullptr.
[[nodiscard]] Thinning find_thinning(std::string_view operation);

}  // namespace thinbench::reference
