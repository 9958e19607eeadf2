// thinbench-study pictures: inputs and what the operations make of them, as image files.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "harness/operation.hpp"
#include "images/image_file.hpp"
#include "measure/row_options.hpp"
#include "study/study.hpp"

namespace thinbench {
namespace {

struct PicturesOptions {
  InputChoice inputs;
  std::string out;
};

void write_results(const std::string& stem, const TimedInput& input) {
  for (const Operation& operation : all_operations()) {
    if (operation.is_net || !operation.timed) continue;
    const ConstImageView view = input.view(operation);
    const auto reference = operation.reference(view.width, view.height, 1);
    if (!reference->gives_image()) continue;
    std::string name = operation.name;
    std::replace(name.begin(), name.end(), ':', '_');
    write_grey(stem + "_" + name + ".png", outcome_of(*reference, view).image.view());
  }
}

int run(const PicturesOptions& options, const Console& console) {
  const std::vector<TimedInput> inputs = timed_inputs(options.inputs, &console.err);
  std::filesystem::create_directories(options.out);
  for (const TimedInput& input : inputs) {
    const std::string stem = options.out + "/" + input.name;
    write_grey(stem + ".png", input.binary.view());
    write_grey(stem + "_grey.png", input.grey.view());
    write_results(stem, input);
  }
  return kSuccess;
}

}  // namespace

Command add_pictures_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("pictures", "Write inputs and results as image files");
  const auto options = std::make_shared<PicturesOptions>();
  app->add_option("--out", options->out, "Directory to write to, made where it is missing")
      ->required()
      ->check(not_empty())
      ->type_name("DIR");
  add_input_options(*app, options->inputs);
  app->footer(R"(Examples:
  thinbench-study pictures --out pictures
  thinbench-study pictures --out pictures --image parts.jpg --foreground dark

Writes DIR/INPUT.png, DIR/INPUT_grey.png and DIR/INPUT_CASE.png for each operation that gives an
image, ':' in the name of a case written as '_'. Nets have learned a rule and give the rule's images.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
