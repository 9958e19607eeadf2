#include "cli/verify_images.hpp"

#include <memory>
#include <utility>

#include "picture/picture.hpp"
#include "scene/scene.hpp"

namespace thinbench {
namespace {

bool is_big(const TestImageSet& set) {
  return set.name == "four_by_four" || set.name == "sizes";
}

TestImage scene_image(SceneKind kind, const std::string& name) {
  SceneOptions options;
  options.kind = kind;
  return {"scene, " + name, render_scene(options).binary};
}

TestImage picture_image(const std::string& file) {
  constexpr std::uint8_t threshold = 128;
  ByteImage image = read_grey(file);
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) image.at(x, y) = image.at(x, y) < threshold ? 0 : 255;
  }
  return {file, std::move(image)};
}

/// A set of images that are there already.
TestImageSet set_of(std::string name, std::string claim, std::vector<TestImage> images) {
  const auto kept = std::make_shared<const std::vector<TestImage>>(std::move(images));
  return {std::move(name), std::move(claim), [kept](const TestImageSink& sink) {
            for (const TestImage& image : *kept) sink(image);
          }};
}

TestImageSet scenes() {
  std::vector<TestImage> images;
  images.push_back(scene_image(SceneKind::kParts, "parts apart"));
  images.push_back(scene_image(SceneKind::kFrameTouching, "parts on the frame"));
  return set_of("scenes", "the scenes that benchmarks use", std::move(images));
}

}  // namespace

std::vector<TestImageSet> verify_image_sets(bool quick, const std::vector<std::string>& files) {
  std::vector<TestImage> pictures;
  pictures.reserve(files.size());
  for (const std::string& file : files) pictures.push_back(picture_image(file));
  std::vector<TestImageSet> sets;
  for (const TestImageSet& set : test_image_sets()) {
    if (!quick || !is_big(set)) sets.push_back(set);
  }
  sets.push_back(scenes());
  if (!pictures.empty()) sets.push_back(set_of("pictures", "the given files", std::move(pictures)));
  return sets;
}

}  // namespace thinbench
