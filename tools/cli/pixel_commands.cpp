// thinbench fill-holes, labels, distance and euler: one result for an image file each.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/thinbench.hpp"
#include "images/binarise.hpp"
#include "images/image_file.hpp"
#include "support/text.hpp"
#include "support/whole_file.hpp"
#include "thinbench/distance.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {
namespace {

struct PixelOptions {
  std::string in;
  std::string out;  // empty: none
  Execution execution;
  BinariseOptions binarise;
  int connectivity = 8;
  std::int64_t max_area = kAnyHoleArea;  // of holes to fill
  Spacing spacing;
  bool real = false;  // distances as real numbers
};

/// Writes the result of an image and says in a line what it is.
using Compute = std::function<std::string(ByteImage image, const PixelOptions& options)>;

int run(const PixelOptions& options, const Compute& compute, const Console& console) {
  FileBytes file = read_input(options.in);
  check_replaced(file, options.out);
  std::ostringstream remarks;  // failures are one line, without them
  ByteImage image = read_binary(std::move(file), options.binarise, remarks);
  const std::string line = compute(std::move(image), options);
  console.err << remarks.str();
  summary_stream(console, options.out) << line << '\n';
  return kSuccess;
}

Connectivity connectivity_of(const PixelOptions& options) {
  return static_cast<Connectivity>(options.connectivity);
}

std::string filled(ByteImage image, const PixelOptions& options) {
  check_extension(options.out);
  const Index before = foreground_pixels(image.view());
  fill_holes(image.view(), image.view(), {connectivity_of(options), options.max_area},
             options.execution);
  write_grey(options.out, image.view());
  return fmt::format("fill-holes: {} x {}, {} before, {} after", image.width(), image.height(),
                     counted(before, "foreground pixel"), foreground_pixels(image.view()));
}

std::string euler(const ByteImage& image, const PixelOptions& options) {
  return fmt::format("{}", euler_number(image.view(), connectivity_of(options), options.execution));
}

std::string labelled(const ByteImage& image, const PixelOptions& options) {
  check_deep_extension(options.out);
  const Index width = image.width(), height = image.height();
  std::vector<std::int32_t> labels(static_cast<std::size_t>(width * height));
  const std::uint32_t objects =
      label_image(image.view(), {labels.data(), width, height}, connectivity_of(options),
                  LabelOrder::pixels, options.execution);
  write_labels(options.out, {labels.data(), width, height});
  return fmt::format("labels: {} x {}, {}", width, height, counted(objects, "object"));
}

/// Distances as they are, or rounded to 16 bits.
void write_distances(const std::vector<double>& found, const PixelOptions& options, Index width,
                     Index height) {
  if (options.real) {
    const std::vector<float> reals(found.begin(), found.end());
    return write_reals(options.out, {reals.data(), width, height});
  }
  std::vector<std::uint16_t> levels(found.size());
  std::ranges::transform(found, levels.begin(),
                         [](double d) { return static_cast<std::uint16_t>(std::lround(d)); });
  write_deep(options.out, {levels.data(), width, height});
}

/// What rounding would lose.
void check_range(double greatest, const PixelOptions& options) {
  constexpr double kMaxLevel = 65535;
  if (options.real) return;
  if (std::round(greatest) > kMaxLevel) {
    throw FileError(fmt::format(
        "{}: expected distances up to {}, the most that 16 bits hold, got {:.6g}; --float "
        "writes real numbers",
        options.in, kMaxLevel, greatest));
  }
  if (greatest > 0 && std::round(greatest) == 0) {
    throw FileError(fmt::format(
        "{}: the greatest distance is {:.6g}, so all become 0; give --spacing in a smaller "
        "unit, or --float",
        options.in, greatest));
  }
}

std::string distance_levels(const ByteImage& image, const PixelOptions& options) {
  (options.real ? check_real_extension : check_deep_extension)(options.out);
  const Index width = image.width(), height = image.height();
  check_sides(options.in, width, height);
  std::vector<double> found(static_cast<std::size_t>(width * height));
  distances(image.view(), {found.data(), width, height}, options.spacing, options.execution);
  const double greatest = *std::max_element(found.begin(), found.end());
  if (std::isinf(greatest)) {
    throw FileError(options.in + ": all of it is foreground, so there is no distance");
  }
  check_range(greatest, options);
  write_distances(found, options, width, height);
  return fmt::format("distance: {} x {}, the greatest is {:.2f}", width, height, greatest);
}

struct PixelCommand {
  const char* name;
  const char* what;
  const char* out;  // describes OUT; nullptr where nothing is written
  bool has_connectivity;
  bool has_max_area;
  bool has_spacing;
  const char* footer;
  Compute compute;
};

Command add_pixel_command(CLI::App& program, const PixelCommand& command) {
  CLI::App* app = program.add_subcommand(command.name, command.what);
  const auto options = std::make_shared<PixelOptions>();
  add_input(*app, options->in);
  if (command.out != nullptr) {
    add_argument(*app, "OUT", options->out, command.out);
  }
  if (command.has_connectivity) {
    add_value(*app, "--connectivity", options->connectivity, "Of objects", one_of({"4", "8"}),
              "8|4")
        ->capture_default_str();
  }
  if (command.has_max_area) {
    add_value(*app, "--max-area", options->max_area,
              "Fill only holes of at most N pixels, 1 to 2^31 (default: all)",
              whole_number(1, kMaxImagePixels), "N");
  }
  if (command.has_spacing) {
    add_spacing_option(*app, options->spacing);
    app->add_flag("--float", options->real, "Write real numbers of 32 bits, as .tif");
  }
  add_isa_option(*app, options->execution.isa);
  add_threads_option(*app, options->execution.threads);
  add_binarise_options(*app, options->binarise);
  app->footer(command.footer);
  return {app, [options, compute = command.compute](const Console& console) {
            return run(*options, compute, console);
          }};
}

}  // namespace

Command add_fill_holes_command(CLI::App& program) {
  return add_pixel_command(
      program,
      {"fill-holes", "Fill the holes of objects",
       "Image to write: .png, .pgm, .bmp, .tif, or - for PNG on standard output", true, true, false,
       R"(Examples:
  thinbench fill-holes parts.png filled.png
  thinbench fill-holes scan.png clean.png --max-area 20
  cat parts.png | thinbench fill-holes - - > filled.png

OUT holds 255 on objects and all that they enclose, and 0 elsewhere. Objects in a hole do not count for
its area; with --max-area they remain as they are.)",
       filled});
}

Command add_labels_command(CLI::App& program) {
  return add_pixel_command(
      program, {"labels", "Number the objects of an image, pixel by pixel",
                "Image of 16 bits to write: .png, .pgm, .tif, or - for PNG on standard output",
                true, false, false,
                R"(Examples:
  thinbench labels parts.png labels.png
  thinbench labels parts.png labels.tif --connectivity 4

OUT holds the number of each pixel's object, from 1 in the order of 'thinbench holes', and 0 elsewhere.
More than 65535 objects need .tif, which then has 32 bits.)",
                labelled});
}

Command add_distance_command(CLI::App& program) {
  return add_pixel_command(
      program, {"distance", "Write the distance of each pixel to the background",
                "Image of 16 bits to write: .png, .pgm, .tif, or - for PNG on standard output",
                false, false, true, R"(Examples:
  thinbench distance parts.png distance.png
  thinbench distance slice.png distance.tif --spacing 0.5,2
  thinbench distance map.tif distance.tif --foreground bright

OUT holds the Euclidean distance to the nearest pixel of the background, in pixels or the unit of
--spacing and, without --float, rounded to a whole number; 0 on the background. What is outside the
image does not count. Sides are at most 32767 pixels.)",
                distance_levels});
}

Command add_euler_command(CLI::App& program) {
  return add_pixel_command(program,
                           {"euler", "Count objects minus holes", nullptr, true, false, false,
                            R"(Examples:
  thinbench euler parts.png
  thinbench euler parts.png --connectivity 4

Holes have the other connectivity.)",
                            euler});
}

}  // namespace thinbench
