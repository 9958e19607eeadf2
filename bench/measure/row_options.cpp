#include "measure/row_options.hpp"

#include <map>

#include "cli/arguments.hpp"
#include "cli/binarise_options.hpp"

namespace thinbench {

void add_row_options(CLI::App& app, InputChoice& inputs, RowChoice& rows) {
  static const std::map<std::string, VariantChoice> choices = {{"all", VariantChoice::all},
                                                               {"highest", VariantChoice::highest},
                                                               {"quick", VariantChoice::quick},
                                                               {"best", VariantChoice::best}};
  CLI::Option* image = app.add_option("--image", inputs.pictures,
                                      "measure on this image, not on the scene (repeatable)");
  add_binarise_options(app, inputs.binarise, image);
  app.add_option("--input", inputs.drawn,
                 "measure on this drawn image, not on the scene: scene, square_N, tiled_N, "
                 "enlarged_N, noise_N_PERCENT_BLOCK, squares_N_SIDE (repeatable)");
  app.add_option("--filter", rows.filter,
                 "rows whose name case/technique/isa/threads/scope/input matches this regular "
                 "expression. A case is an operation, with ':keep' where the image border is kept "
                 "and ':N' for at most N iterations. Of the cases that keep the border only those "
                 "of OpenCV's rules are measured by default; spell out the name of another: "
                 "'^thin_mb2:keep/'");
  app.add_option("--variants", rows.variants,
                 "all; highest: the highest ISA of each technique; quick: and AVX2; best: the "
                 "library's choice and its best scalar variant")
      ->transform(CLI::CheckedTransformer(choices, CLI::ignore_case))
      ->type_name("CHOICE");
  app.add_option("--threads", rows.threads, "threads of threaded variants (repeatable)")
      ->check(whole_number(2, 1024))
      ->type_name("N")
      ->capture_default_str();
  app.add_flag("!--no-peers", rows.peers, "omit other projects' code and the copy");
}

}  // namespace thinbench
