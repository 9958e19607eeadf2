// thinbench edges: marks the edges of one picture file in another.
#include <chrono>
#include <iomanip>
#include <memory>
#include <string>

#include <tbb/global_control.h>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/names.hpp"
#include "cli/variant_choice.hpp"
#include "harness/rows.hpp"
#include "picture/objects.hpp"
#include "picture/picture.hpp"

namespace thinbench {
namespace {

constexpr const char* kExamples = R"(Examples:
  thinbench edges parts.png edges.png --operator sobel --p1 40 --p2 128
  thinbench edges night.jpg edges.png --operator mero_vassy_5x5 --p1 25 --p2 100 --invert
  thinbench edges big.tif edges.tif --operator prewitt --threads 8

An edge needs a gradient above P1 (in grey levels: a vertical step of height h reads h) and a pixel
above P2 in its 3 x 3 neighbourhood. P2 lies below the background, which must be the bright side:
--invert is for bright parts on a dark ground.)";

constexpr std::string_view kPrefix = "edges_";

struct EdgesOptions {
  std::string in;
  std::string out;
  std::string op = "sobel";
  std::string technique;
  std::string isa;
  EdgeThresholds thresholds;
  int threads = 1;
  bool invert = false;
};

const EdgeOperation& operator_named(const std::string& name) {
  if (const auto* operation = find_edge_operation(std::string(kPrefix) + name)) return *operation;
  std::vector<std::string_view> known;
  for (const EdgeOperation& operation : edge_operations()) {
    known.push_back(operation.name.substr(kPrefix.size()));
  }
  refuse_name("operator", name, known);
}

Options wish_of(const EdgesOptions& options) {
  Options wish;
  if (!options.technique.empty()) wish.technique = technique_named(options.technique);
  if (!options.isa.empty()) wish.isa = isa_named(options.isa);
  wish.threads = options.threads;
  return wish;
}

/// The picture with a bright background.
ByteImage bright_ground(ByteImage grey, bool invert) {
  if (!invert) return grey;
  for (Index y = 0; y < grey.height(); ++y) {
    std::uint8_t* row = grey.view().row(y);
    for (Index x = 0; x < grey.width(); ++x) row[x] = static_cast<std::uint8_t>(255 - row[x]);
  }
  return grey;
}

int run(const EdgesOptions& options, std::ostream& out) {
  const EdgeOperation& operation = operator_named(options.op);
  const Options wish = wish_of(options);
  check_ending(options.out);
  const ByteImage grey = bright_ground(read_grey(options.in), options.invert);
  const EdgeVariant& variant = variant_for(operation, grey.width(), wish);
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(wish.threads));
  EdgePlan plan(operation, variant, grey.width(), grey.height(),
                {options.thresholds, wish.threads});
  ByteImage edges(grey.width(), grey.height());
  const auto start = std::chrono::steady_clock::now();
  plan.run(grey.view(), edges.view());
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  write_grey(options.out, edges.view());
  out << row_name(operation.name, technique_name(variant.facts.technique),
                  isa_name(variant.facts.isa), wish.threads)
      << ": " << grey.width() << " x " << grey.height() << ", " << object_pixels(edges.view())
      << " edge pixels, " << std::fixed << std::setprecision(3) << time.count() << " ms\n";
  return kSuccess;
}

void add_threshold(CLI::App& app, const std::string& name, int& value, const std::string& what) {
  app.add_option(name, value, what + ", 0 to 255")
      ->check(whole_number(0, kLargestThreshold))
      ->type_name("N")
      ->capture_default_str();
}

}  // namespace

Command add_edges_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("edges", "Mark the edges of a picture file in another");
  const auto options = std::make_shared<EdgesOptions>();
  app->add_option("IN", options->in, "Picture to read")->required()->type_name("");
  app->add_option("OUT", options->out, "Picture to write: .png, .pgm, .bmp or .tif")
      ->required()
      ->type_name("");
  app->add_option("--operator", options->op,
                  "roberts4, roberts9, mero_vassy, mero_vassy_5x5, sobel or prewitt")
      ->type_name("NAME")
      ->capture_default_str();
  add_threshold(*app, "--p1", options->thresholds.p1, "Gradient that an edge must exceed");
  add_threshold(*app, "--p2", options->thresholds.p2, "Grey level that the background exceeds");
  app->add_flag("--invert", options->invert, "Parts are brighter than the background");
  app->add_option("--technique", options->technique, "How to compute (default: the fastest)")
      ->check(not_empty())
      ->type_name("NAME");
  app->add_option("--isa", options->isa, "Instruction set (default: the highest)")
      ->check(not_empty())
      ->type_name("NAME");
  add_threads_option(*app, options->threads);
  app->footer(kExamples);
  return {app, [options](const Console& console) { return run(*options, console.out); }};
}

}  // namespace thinbench
