#include "cli/verify_images.hpp"

#include <memory>
#include <utility>

#include "picture/picture.hpp"
#include "scene/scene.hpp"

namespace thinbench {
namespace {

bool is_big(const TestImageSet& set) {
  return set.name == "sizes" || set.name == "grey_noise";
}

TestImage scene_image(SceneKind scene_kind, const std::string& name, InputKind kind) {
  SceneOptions options;
  options.kind = scene_kind;
  Scene scene = render_scene(options);
  return {"scene, " + name,
          kind == InputKind::grey ? std::move(scene.grey) : std::move(scene.binary), kind};
}

/// Files to compare on, and how they become binary.
struct GivenImages {
  const std::vector<std::string>& files;
  const BinariseOptions& binarise;
  std::ostream& log;

  [[nodiscard]] TestImage image(const std::string& file, InputKind kind) const {
    if (kind == InputKind::grey) return {file, read_grey(file), kind};
    return {file, read_binary(file, binarise, &log), kind};
  }
};

/// A set of images that are there already.
TestImageSet set_of(std::string name, std::string claim, std::vector<TestImage> images) {
  const InputKind kind = images.front().kind;
  const auto kept = std::make_shared<const std::vector<TestImage>>(std::move(images));
  const auto generate = [kept](const TestImageSink& sink) {
    for (const TestImage& image : *kept) sink(image);
  };
  return {std::move(name), std::move(claim), generate, kind};
}

/// Names of binary sets stay bare.
std::string named(InputKind kind, const std::string& name) {
  return (kind == InputKind::grey ? "grey_" : "") + name;
}

TestImageSet scenes(InputKind kind) {
  std::vector<TestImage> images;
  images.push_back(scene_image(SceneKind::parts, "parts apart", kind));
  images.push_back(scene_image(SceneKind::frame_touching, "parts on the frame", kind));
  return set_of(named(kind, "scenes"), "the scenes that benchmarks use", std::move(images));
}

TestImageSet pictures(InputKind kind, const GivenImages& given) {
  std::vector<TestImage> images;
  images.reserve(given.files.size());
  for (const std::string& file : given.files) images.push_back(given.image(file, kind));
  return set_of(named(kind, "pictures"), "the given files", std::move(images));
}

}  // namespace

std::vector<TestImageSet> verify_image_sets(bool quick, const std::vector<std::string>& files,
                                            const BinariseOptions& binarise, std::ostream& log) {
  std::vector<TestImageSet> sets;
  for (const TestImageSet& set : test_image_sets()) {
    if (!quick || !is_big(set)) sets.push_back(set);
  }
  for (const InputKind kind : {InputKind::binary, InputKind::grey}) {
    sets.push_back(scenes(kind));
    if (!files.empty()) sets.push_back(pictures(kind, {files, binarise, log}));
  }
  return sets;
}

}  // namespace thinbench
