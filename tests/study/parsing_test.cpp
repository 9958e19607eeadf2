#include <gtest/gtest.h>

#include "program_run.hpp"
#include "support/command_help.hpp"

namespace thinbench {
namespace {

TEST(Program, every_help_has_examples) {
  EXPECT_EQ(all_commands(study_program()).size(), 1 + 10 + 2 + 7U);
  expect_every_help_has_examples(study_program());
}

TEST(Program, unknown_subcommand_is_rejected_with_the_nearest_name) {
  EXPECT_EQ(failure_of({"train", "two-layers"}, 2),
            "no command is named 'two-layers'; did you mean 'two-layer'?");
  EXPECT_EQ(failure_of({"experiment", "nothing"}, 2),
            "no command is named 'nothing'; known: edge-quality, literal-holes, cluster-runs, "
            "quantisation, hidden-neurons, quality and operation-counts");
  EXPECT_EQ(failure_of({"train"}, 2),
            "train needs one more word: two-layer or cluster; see 'thinbench-study train --help'");
}

TEST(Program, unknown_option_of_a_subcommand_is_rejected_with_the_nearest_name) {
  EXPECT_EQ(failure_of({"train", "two-layer", "--sead", "2"}, 2),
            "there is no option '--sead'; did you mean '--seed'? See 'thinbench-study train "
            "two-layer --help'");
  EXPECT_EQ(failure_of({"experiment", "quantisation", "--quick"}, 2),
            "there is no option '--quick'; see 'thinbench-study experiment quantisation --help'");
  EXPECT_EQ(failure_of({"train", "--seed", "2", "two-layer"}, 2),
            "there is no option '--seed'; see 'thinbench-study train --help'");
  EXPECT_EQ(failure_of({"train", "cluster", "more"}, 2),
            "'more' was not expected; see 'thinbench-study train cluster --help'");
}

TEST(Program, empty_values_are_rejected) {
  EXPECT_EQ(failure_of({"train", "cluster", "--out", ""}, 2),
            "--out: expected a value, got ''; see 'thinbench-study train cluster --help'");
}

TEST(Program, options_of_images_require_an_image_where_the_scene_is_the_default) {
  for (const Words& command :
       {Words{"verify"}, Words{"instructions"}, Words{"experiment", "quality"}}) {
    for (const Words& option : {Words{"--foreground", "dark"}, Words{"--threshold", "9"}}) {
      Words words = command;
      words.insert(words.end(), option.begin(), option.end());
      EXPECT_EQ(failure_of(words, 2).find(option.front() + " requires --image; see '"), 0U)
          << failure_of(words, 2);
    }
  }
}

TEST(Program, images_that_cannot_be_read_are_rejected) {
  for (const Words& words :
       {Words{"verify", "--image", "absent.png"}, Words{"instructions", "--image", "absent.png"},
        Words{"experiment", "quality", "--image", "absent.png"},
        Words{"run", "holes", "absent.png", "out.png"}}) {
    EXPECT_EQ(failure_of(words, 1), "cannot read 'absent.png': there is no such file");
  }
}

}  // namespace
}  // namespace thinbench
