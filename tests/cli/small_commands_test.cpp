#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/thread_team.hpp"
#include "images/image_file.hpp"
#include "peers/peers.hpp"
#include "program_run.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

/// Borders and limits are no operations of their own.
std::vector<Operation> listed() {
  std::vector<Operation> operations = operations_with_peers();
  std::erase_if(operations, [](const Operation& one) {
    return one.border == Border::keep || one.max_iterations.has_value();
  });
  return operations;
}

std::size_t catalogue_size() {
  std::size_t rows = 0;
  for (const Operation& operation : listed()) rows += operation.variants.size();
  return rows;
}

/// The lines of `list` after its head.
std::vector<std::string> listed_operations() {
  std::istringstream lines(run_with({"list"}).out);
  std::vector<std::string> found;
  for (std::string line; std::getline(lines, line);) found.push_back(line);
  found.erase(found.begin());
  return found;
}

TEST(ListCommand, prints_a_line_for_each_operation) {
  const std::vector<std::string> lines = listed_operations();
  const std::vector<Operation> operations = listed();
  ASSERT_EQ(lines.size(), operations.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::regex pattern(operations[i].name + R"( +[1-9]\d* +\w+/[\w.]+ +\S.*)");
    EXPECT_TRUE(std::regex_match(lines[i], pattern)) << lines[i];
    EXPECT_NE(lines[i].find(operations[i].description), std::string::npos) << lines[i];
  }
}

TEST(ListCommand, counts_the_librarys_variants_that_run_here_and_names_what_run_takes) {
  const IsaCap cap("baseline");
  const TemporaryDirectory directory;
  const std::string file = directory.file("a.png");
  write_grey(file, ByteImage(1024, 9).view());
  const std::string run = run_with({"run", "thin_guo_hall", file, file}).out;
  const std::string first_two = run.substr(0, run.find("/1: "));  // operation/technique/isa
  int listed = 0;
  for (const std::string& line : listed_operations()) {
    std::istringstream words(line);
    std::string operation;
    std::string variants;
    std::string fastest;
    words >> operation >> variants >> fastest;
    if (operation == "fill_holes") {
      EXPECT_EQ(variants, "2") << "with its one peer 3";
    }
    if (operation != "thin_guo_hall") continue;
    EXPECT_EQ(operation + "/" + fastest, first_two);
    ++listed;
  }
  EXPECT_EQ(listed, 1);
}

TEST(ListCommand, variants_are_an_aligned_line_for_every_row) {
  const ProgramRun run = run_with({"list", "--variants"});
  EXPECT_EQ(run.status, 0);
  std::istringstream lines(run.out);
  std::string header;
  std::getline(lines, header);
  const std::size_t column = header.find("available");
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line) && !line.empty(); ++rows) {
    const std::string cell = line.substr(column);
    EXPECT_TRUE(cell == "yes" || cell.rfind("no: ", 0) == 0) << line;
  }
  EXPECT_EQ(rows, catalogue_size());
}

TEST(ListCommand, json_says_why_a_row_is_not_available) {
  const IsaCap cap("baseline");
  const ProgramRun run = run_with({"list", "--json"});
  EXPECT_EQ(run.status, 0);
  const Json list = Json::parse(run.out);
  EXPECT_EQ(list.size(), catalogue_size());
  for (const Json& row : list) {
    EXPECT_EQ(row.size(), 10U);
    EXPECT_TRUE(!row["fastest"] || (row["available"] && !row["peer"] && row["threads"] == "1"));
    EXPECT_LE(row["min_pixels"], row["threads"] == "n" ? detail::kMinPixelsForThreads : 0);
    EXPECT_EQ(row["available"], row["isa"] == "baseline" || row["peer"]);
    EXPECT_EQ(row["available"], row["reason"] == "");
    EXPECT_TRUE(row["threads"] == "1" || row["threads"] == "n");
    EXPECT_NE(row["operation"], "");
    EXPECT_NE(row["technique"], "");
    EXPECT_NE(row["description"], "");
  }
}

TEST(SceneCommand, writes_the_scene_and_says_what_it_shows) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("scene.png");
  const ProgramRun run = run_with({"scene", file, "--scale", "2", "--noise", "0"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(std::regex_match(run.out.substr(file.size()),
                               std::regex(R"(: 1020 x 824, \d+ parts, \d+ holes\n)")))
      << run.out;
  EXPECT_EQ(read_grey(file).width(), 1020);
}

TEST(SceneCommand, binary_image_holds_0_and_255_only) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("scene.pgm");
  ASSERT_EQ(run_with({"scene", file, "--binary", "--border-touching"}).status, 0);
  const ByteImage image = read_grey(file);
  std::set<int> levels;
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) levels.insert(image.at(x, y));
  }
  EXPECT_EQ(levels, (std::set<int>{0, 255}));
}

TEST(SceneCommand, every_option_changes_the_picture) {
  const TemporaryDirectory directory;
  std::set<std::string> pictures;
  const std::vector<std::vector<std::string>> options = {
      {}, {"--noise", "0.5"}, {"--seed", "7"}, {"--no-illumination"}, {"--border-touching"}};
  for (std::vector<std::string> args : options) {
    args.insert(args.begin(), {"scene", directory.file("a.pgm")});
    ASSERT_EQ(run_with(args).status, 0);
    pictures.insert(bytes_of(directory.file("a.pgm")));
  }
  EXPECT_EQ(pictures.size(), options.size());
}

TEST(SceneCommand, truth_needs_no_picture) {
  const ProgramRun run = run_with({"scene", "--truth"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(Json::parse(run.out)["width"], 510);
}

TEST(SceneCommand, truth_and_image_come_together) {
  const TemporaryDirectory directory;
  const ProgramRun run = run_with({"scene", directory.file("a.png"), "--truth"});
  EXPECT_FALSE(Json::parse(run.out)["parts"].empty());
  EXPECT_EQ(directory.names(), std::set<std::string>{"a.png"});
}

TEST(SceneCommand, rejects_what_it_cannot_draw) {
  const std::string see = "; see 'thinbench scene --help'";
  EXPECT_EQ(failure_of({"scene"}, 2), "scene needs OUT, an image to write, or --truth");
  EXPECT_EQ(failure_of({"scene", "a.png", "--scale", "0"}, 2),
            "--scale: expected an integer in [1, 100], got '0'" + see);
  EXPECT_EQ(failure_of({"scene", "a.png", "--noise", "nan"}, 2),
            "--noise: expected a number in [0, 255], got 'nan'" + see);
  EXPECT_EQ(failure_of({"scene", "a.png", "--seed", "-5"}, 2),
            "--seed: expected an integer in [0, 18446744073709551615], got '-5'" + see);
  EXPECT_EQ(failure_of({"scene", "a.xyz"}, 2).find("cannot write 'a.xyz'"), 0U);
}

TEST(MachineCommand, prints_json_with_commit_and_options) {
  const ProgramRun run =
      run_with({"machine", "--commit", "abc", "--options", R"({"quick": true})"});
  EXPECT_EQ(run.status, 0);
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json["commit"], "abc");
  EXPECT_EQ(json["options"]["quick"], true);
  EXPECT_EQ(run_with({"machine", "--fingerprint"}).out,
            json["fingerprint"].get<std::string>() + "\n");
}

TEST(MachineCommand, rejects_options_that_are_no_object) {
  for (const std::string text : {"{", "[1]", "quick"}) {
    EXPECT_EQ(failure_of({"machine", "--options", text}, 2),
              "--options: '" + text + R"(' is not a JSON object such as {"quick": true})");
  }
}

}  // namespace
}  // namespace thinbench
