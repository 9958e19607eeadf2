#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "images/image_file.hpp"
#include "program_run.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

constexpr const char* kRows = "^euler_number/bitpacked/baseline/1/";

Words counting(const Words& more) {
  Words words = {"instructions", "--filter", kRows};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(InstructionsCommand, counts_are_equal_to_those_that_were_just_stored) {
  const TemporaryDirectory folder;
  const std::string file = folder.file("counts.json");
  const ProgramRun first = run_with(counting({"--out", file}));
  EXPECT_EQ(first.status, 0) << first.err;
  EXPECT_NE(first.out.find("euler_number/bitpacked/baseline/1/kernel/scene_small"),
            std::string::npos);
  EXPECT_EQ(run_with(counting({"--json"})).out, bytes_of(file));
  const ProgramRun again = run_with(counting({"--against", file}));
  EXPECT_EQ(again.status, 0);
  EXPECT_EQ(again.out, "2 rows compared: 0 take more instructions, 0 fewer (tolerance 1 %)\n");
}

TEST(InstructionsCommand, more_instructions_than_stored_are_exit_status_1_and_none_in_common_4) {
  const TemporaryDirectory folder;
  Json counts = Json::parse(run_with(counting({"--json"})).out);
  counts["rows"][0]["instructions"] = 100;
  const std::string less = folder.with("less.json", counts.dump());
  EXPECT_EQ(run_with(counting({"--against", less})).status, 1);
  counts["rows"] = Json::array();
  const std::string none = folder.with("none.json", counts.dump());
  EXPECT_EQ(run_with(counting({"--against", none})).status, 4);
}

TEST(InstructionsCommand, limits_give_instructions_per_cycle) {
  const ProgramRun run = run_with(counting({"--limits", "--quick", "--json"}));
  EXPECT_EQ(run.status, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json.at("/input/height"_json_pointer), 24);
  ASSERT_EQ(json.at("rows").size(), 1U);
  EXPECT_GT(json.at("/rows/0/instructions_per_cycle"_json_pointer), 0.1);
}

TEST(InstructionsCommand, images_are_binarised_as_asked_for) {
  const TemporaryDirectory folder;
  const std::string file = folder.file("a.png");
  ByteImage image(100, 64);
  for (Index x = 20; x < 80; ++x) image.at(x, 16) = 200;
  write_grey(file, image.view());
  const auto hash = [&](const Words& more) {
    Words words = {"--json", "--image", file};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramRun run = run_with(counting(words));
    return Json::parse(run.out).at("/input/hash"_json_pointer).get<std::string>() +
           (run.err.find("note: " + file + ": foreground is bright") == 0 ? " noted" : "");
  };
  const std::string bright = hash({"--foreground", "bright", "--threshold", "1"});
  EXPECT_EQ(hash({}), bright + " noted");
  EXPECT_NE(hash({"--foreground", "dark", "--threshold", "1"}), bright);
}

TEST(InstructionsCommand, options_that_do_not_go_together_are_refused) {
  EXPECT_EQ(failure_of({"instructions", "--against", "x", "--limits"}, 2),
            "--against goes with neither --json nor --limits");
  EXPECT_EQ(failure_of({"instructions", "--quick"}, 2), "--quick goes with --limits only");
  EXPECT_EQ(failure_of({"instructions", "--against", "absent.json"}, 1),
            "'absent.json' cannot be read");
}

}  // namespace
}  // namespace thinbench
