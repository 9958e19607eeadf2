#include "measure/row_options.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "cli/arguments.hpp"

namespace thinbench {
namespace {

constexpr std::array<std::string_view, 4> kVariantChoices = {"usual", "all", "highest", "best"};

void choose_variants(RowChoice& rows, const std::string& name) {
  const auto* const found = std::find(kVariantChoices.begin(), kVariantChoices.end(), name);
  rows.variants = static_cast<VariantChoice>(found - kVariantChoices.begin());
}

}  // namespace

void add_input_options(CLI::App& app, InputChoice& inputs) {
  CLI::Option* image = add_value(app, "--image", inputs.pictures,
                                 "this image, not the scene (repeatable)", not_empty(), "FILE")
                           ->allow_extra_args(false);
  add_binarise_options(app, inputs.binarise, image);
  app.add_option("--input", inputs.drawn,
                 "this drawn image, not the scene: scene, square_N, tiled_N, enlarged_N, "
                 "noise_N_PERCENT_BLOCK, squares_N_SIDE, halftone_N, page_N, strokes_SIDE_COUNT "
                 "(repeatable)")
      ->type_name("NAME")
      ->allow_extra_args(false);
}

void add_row_options(CLI::App& app, InputChoice& inputs, RowChoice& rows) {
  add_input_options(app, inputs);
  app.add_option("--filter", rows.filter,
                 "rows whose name case/technique/isa/threads/scope/input matches this regular "
                 "expression. A case is an operation, with ':keep' where the image border is kept "
                 "and ':N' for at most N iterations. Of the cases that keep the border only those "
                 "of OpenCV's rules are measured by default; spell out the name of another: "
                 "'^thin_mb2:keep/'");
  add_value(
      app, "--variants", [&rows](const std::string& name) { choose_variants(rows, name); },
      "default all; usual: the best of each ISA and each technique once; highest: "
      "the highest ISA of each technique, both with threads only where the library would "
      "use them; best: the library's choice and its best scalar variant",
      one_of({kVariantChoices.begin(), kVariantChoices.end()}), "all|usual|highest|best");
  add_value(app, "--threads", rows.threads, "threads of threaded variants (repeatable)",
            whole_number(2, 1024), "N")
      ->capture_default_str();
  app.add_flag_callback(
      "--no-peers", [&rows] { rows.peers = false; }, "omit other projects' code and the copy");
}

}  // namespace thinbench
