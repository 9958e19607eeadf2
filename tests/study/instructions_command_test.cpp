#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "images/image_file.hpp"
#include "program_run.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

constexpr const char* kFilter = "^euler_number/bitpacked/baseline/1/";

/// A command that counts two cases.
Words count_command(const Words& more) {
  Words words = {"instructions", "--filter", kFilter};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(InstructionsCommand, image_is_binarised_by_the_given_options) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("a.png");
  ByteImage image(100, 64);
  for (Index x = 20; x < 80; ++x) image.at(x, 16) = 200;
  write_grey(file, image.view());
  const auto hash_of = [](const ProgramRun& run) {
    return Json::parse(run.out).at("/input/hash"_json_pointer);
  };
  const ProgramRun bright = run_with(count_command({"--json", "--image", file}));
  EXPECT_EQ(bright.err.find("note: " + file + ": foreground is bright"), 0U) << bright.err;
  const ProgramRun dark =
      run_with(count_command({"--json", "--image", file, "--foreground", "dark"}));
  EXPECT_NE(hash_of(dark), hash_of(bright));
}

}  // namespace
}  // namespace thinbench
