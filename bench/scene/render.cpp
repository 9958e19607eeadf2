#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "harness/splitmix64.hpp"
#include "scene/coverage.hpp"
#include "scene/integer_math.hpp"
#include "scene/scene.hpp"
#include "scene/truth.hpp"

namespace thinbench {
namespace {

using namespace scene_detail;

// Grey levels under even light.
constexpr std::int64_t kPartGrey = 56;
constexpr std::int64_t kBackgroundGrey = 204;

/// Halfway between part and background, so that a pixel belongs to a part where more than half of
/// it is covered. Light from 91.9 % to 102.7 % leaves more than 57 levels on both sides.
constexpr int kThreshold = 130;

/// Light is counted in 1/4096 of even light.
constexpr std::int64_t kEvenLight = 4096;

/// One axis' share of the light, for all pixels along it: slope and curvature are what is lost at
/// the far end through either. With the axis running from -1 to 1 over `count` pixels, the share is
/// -slope t - curvature t^2.
std::vector<std::int64_t> light_profile(Index count, std::int64_t slope, std::int64_t curvature) {
  constexpr std::int64_t kOne = 1024;
  std::vector<std::int64_t> profile;
  for (Index i = 0; i < count; ++i) {
    const std::int64_t t = floor_div((2 * i + 1) * kOne, count) - kOne;
    profile.push_back(-round_div(slope * t * kOne + curvature * t * t, kOne * kOne));
  }
  return profile;
}

struct Light {
  std::vector<std::int64_t> across;
  std::vector<std::int64_t> down;
};

Light scene_light(const SceneOptions& options, Index width, Index height) {
  if (!options.illumination) return {light_profile(width, 0, 0), light_profile(height, 0, 0)};
  return {light_profile(width, 130, 60), light_profile(height, 90, 50)};
}

/// Light that falls on a surface partly covered by a part, in 1/16 grey level.
std::int64_t lit_grey_16(std::int64_t coverage, std::int64_t light) {
  const std::int64_t surface =
      kBackgroundGrey * (CoverageMap::kFullCoverage - coverage) + kPartGrey * coverage;
  return round_div(surface * light * 16, kEvenLight * CoverageMap::kFullCoverage);
}

void draw_row(const SceneOptions& options, const Light& light, const CoverageMap& map, Index y,
              ImageView grey) {
  const std::int64_t row_light = kEvenLight + light.down[static_cast<std::size_t>(y)];
  const std::int16_t* coverage = map.row(y);
  std::uint8_t* pixels = grey.row(y);
  for (Index x = 0; x < grey.width; ++x) {
    const auto place = static_cast<std::uint64_t>(y * grey.width + x);
    const std::int64_t level =
        lit_grey_16(coverage[x], row_light + light.across[static_cast<std::size_t>(x)]) +
        noise_from(splitmix64(options.seed, place), options.noise_sigma_16);
    pixels[x] = static_cast<std::uint8_t>(std::clamp<std::int64_t>(round_div(level, 16), 0, 255));
  }
}

std::vector<Contour> all_contours(const std::vector<PartShape>& layout) {
  std::vector<Contour> contours;
  for (const PartShape& part : layout) {
    contours.push_back(part.body.outline);
    for (const NamedShape& hole : part.holes) contours.push_back(hole.outline);
  }
  return contours;
}

ByteImage draw(const SceneOptions& options, const std::vector<PartShape>& layout) {
  ByteImage grey(kSceneWidth * options.scale, kSceneHeight * options.scale);
  const CoverageMap map({0, 0, grey.width(), grey.height()}, all_contours(layout));
  const Light light = scene_light(options, grey.width(), grey.height());
  for (Index y = 0; y < grey.height(); ++y) draw_row(options, light, map, y, grey.view());
  return grey;
}

}  // namespace

ByteImage threshold_dark(ConstImageView grey, int threshold) {
  return image_by(grey.width, grey.height,
                  [&](Index x, Index y) { return grey.row(y)[x] < threshold ? 255 : 0; });
}

Scene render_scene(const SceneOptions& options) {
  if (options.scale < 1 || options.noise_sigma_16 < 0) {
    throw std::invalid_argument("render_scene: scale below 1 or negative noise");
  }
  const std::vector<PartShape> layout = scaled_layout(options);
  Scene scene;
  scene.grey = draw(options, layout);
  scene.threshold = kThreshold;
  scene.binary = threshold_dark(std::as_const(scene.grey).view(), kThreshold);
  auto [parts, holes] = measure(layout, std::as_const(scene.binary).view());
  scene.parts = std::move(parts);
  scene.holes = std::move(holes);
  return scene;
}

}  // namespace thinbench
