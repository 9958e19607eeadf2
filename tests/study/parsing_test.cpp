#include <gtest/gtest.h>

#include "program_run.hpp"
#include "support/command_help.hpp"

namespace thinbench {
namespace {

TEST(Program, every_help_has_examples) {
  EXPECT_EQ(all_commands(study_program()).size(), 1 + 8 + 2 + 7U);
  expect_every_help_has_examples(study_program());
}

}  // namespace
}  // namespace thinbench
