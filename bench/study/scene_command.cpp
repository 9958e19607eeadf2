// thinbench-study scene: the benchmark's test image and its ground truth.
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "images/image_file.hpp"
#include "scene/scene.hpp"
#include "scene/scene_truth.hpp"
#include "study/study.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

constexpr int kMaxScale = 100;  // just below 2^31 pixels

struct SceneCommandOptions {
  std::string out;
  bool border_touching = false;
  bool binary = false;
  int scale = 1;
  double noise = 6;
  bool no_illumination = false;
  std::uint64_t seed = 1999;
  bool truth = false;
};

SceneOptions scene_options(const SceneCommandOptions& options) {
  return {options.border_touching ? SceneKind::border_touching : SceneKind::parts, options.scale,
          static_cast<int>(std::lround(options.noise * 16)), !options.no_illumination,
          options.seed};
}

int draw(const SceneCommandOptions& options, std::ostream& out) {
  if (options.out.empty() && !options.truth) {
    throw UsageError("scene needs OUT, an image to write, or --truth");
  }
  if (!options.out.empty()) {
    check_extension(options.out);
    check_target(options.out);
  }
  const Scene scene = render_scene(scene_options(options));
  if (!options.out.empty()) {
    write_grey(options.out, (options.binary ? scene.binary : scene.grey).view());
  }
  if (options.truth) {
    out << scene_truth_json(scene) << '\n';
  } else {
    out << options.out << ": " << scene.grey.width() << " x " << scene.grey.height() << ", "
        << scene.parts.size() << " parts, " << scene.holes.size() << " holes\n";
  }
  return kSuccess;
}

}  // namespace

Command add_scene_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("scene", "Draw machined parts whose geometry is known");
  const auto options = std::make_shared<SceneCommandOptions>();
  app->add_option("OUT", options->out, "Image to write: .png, .pgm, .bmp or .tif")->type_name("");
  app->add_flag("--border-touching", options->border_touching, "Let parts touch the image border");
  app->add_flag("--binary", options->binary, "255 on parts, 0 elsewhere, instead of grey");
  add_value(*app, "--scale", options->scale, "Magnification of 510 x 412 pixels, 1 to 100",
            whole_number(1, kMaxScale), "N")
      ->capture_default_str();
  add_value(*app, "--noise", options->noise, "Standard deviation in grey levels, 0 to 255",
            real_number(0, 255), "SIGMA")
      ->capture_default_str();
  app->add_flag("--no-illumination", options->no_illumination, "Light the scene evenly");
  add_value(*app, "--seed", options->seed, "Picks the noise, 0 to 2^64 - 1",
            whole_number(0, UINT64_MAX), "N")
      ->capture_default_str();
  app->add_flag("--truth", options->truth, "Print the true geometry as JSON");
  app->footer(R"(Examples:
  thinbench-study scene parts.png
  thinbench-study scene parts.png --truth > parts.json
  thinbench-study scene objects.pgm --binary --border-touching --scale 4 --noise 0)");
  return {app, [options](const Console& console) { return draw(*options, console.out); }};
}

}  // namespace thinbench
