// The benchmark's test images: machined parts with holes, dark on a bright background, drawn from
// exact geometry by integer arithmetic, so that every machine draws the same bytes.
//
// Pixel centres have integer coordinates: pixel (x, y) covers x - 0.5 .. x + 0.5 and
// y - 0.5 .. y + 0.5, with x to the right and y downwards. All lengths are pixels of the image as
// rendered, so they grow with the scale.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/byte_image.hpp"

namespace thinbench {

enum class SceneKind {
  parts,            ///< every part lies apart from the others and from the image border
  border_touching,  ///< several parts touch the image border or are cut off by it, on all four
                    ///< sides
};

struct SceneOptions {
  SceneKind kind = SceneKind::parts;
  /// Magnification of the geometry, at least 1; the image has 510 scale x 412 scale pixels.
  int scale = 1;
  /// Standard deviation of the noise in 1/16 grey level; 0 for none.
  int noise_sigma_16 = 96;
  /// Lights the scene from the top left; otherwise evenly.
  bool illumination = true;
  /// Picks the noise, nothing else.
  std::uint64_t seed = 1999;
};

struct ScenePoint {
  double x = 0;
  double y = 0;
};

/// Extent of an outline with its whole thickness: real coordinates, not pixel numbers.
struct SceneBox {
  double x_min = 0;
  double y_min = 0;
  double x_max = 0;
  double y_max = 0;
};

/// True geometry of a part. Where the image border cuts the part off, `area`, `centre` and `box`
/// still describe the complete part.
struct ScenePart {
  /// Counts from 1, in raster order of the part's first pixel in the binary image.
  int id = 0;
  std::string kind;
  /// Without the holes.
  double area = 0;
  /// Centre of mass, holes left out.
  ScenePoint centre;
  SceneBox box;
  /// Whether a piece of the part lies outside the image.
  bool cut_by_border = false;
};

/// True geometry of a hole that lies inside the image as a whole; others are left out.
struct SceneHole {
  /// Counts from 1, in raster order of the hole's first pixel in the binary image.
  int id = 0;
  /// Id of the part that the hole belongs to.
  int part = 0;
  std::string kind;
  /// Centre of mass.
  ScenePoint centre;
  double area = 0;
};

struct Scene {
  ByteImage grey;
  /// 255 on parts (grey below `threshold`), 0 on the background and in holes.
  ByteImage binary;
  int threshold = 0;
  /// In the order of their ids, as are the holes.
  std::vector<ScenePart> parts;
  std::vector<SceneHole> holes;
};

/// Draws a scene; the same options give the same bytes everywhere. Throws std::invalid_argument for
/// a scale below 1 or a negative noise.
[[nodiscard]] Scene render_scene(const SceneOptions& options = {});

/// 255 where `grey` is below the threshold, 0 elsewhere.
[[nodiscard]] ByteImage threshold_dark(ConstImageView grey, int threshold);

}  // namespace thinbench
