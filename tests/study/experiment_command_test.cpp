#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "images/image_file.hpp"
#include "program_run.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

TEST(ExperimentCommand, prints_a_table_and_writes_the_data) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("quantisation.json");
  const ProgramRun ran = run_with({"experiment", "quantisation", "--out", file});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("| rounded | 0 | 251 | 252 | 20 |"), std::string::npos);
  EXPECT_EQ(ran.err, "wrote " + file + "\n");
  EXPECT_EQ(Json::parse(bytes_of(file)).at("experiment"), "quantisation");
}

TEST(ExperimentCommand, every_experiment_prints_a_table) {
  for (const char* name : {"cluster-runs", "literal-holes", "quantisation", "operation-counts"}) {
    EXPECT_NE(run_with({"experiment", name}).out.find("| --- |"), std::string::npos) << name;
  }
  const ProgramRun ran = run_with({"experiment", "hidden-neurons", "--quick"});
  EXPECT_NE(ran.out.find("| 12 | 256 |"), std::string::npos) << ran.out;
  EXPECT_NE(ran.err.find("hidden neurons: 91 %"), std::string::npos) << ran.err;
}

TEST(ExperimentCommand, quality_takes_pictures_and_leaves_skeletons) {
  const TemporaryDirectory directory;
  const std::string picture = directory.file("spot.png");
  ByteImage spot(20, 10);
  for (Index x = 4; x < 15; ++x) spot.at(x, 5) = spot.at(x, 6) = spot.at(x, 7) = 255;
  write_grey(picture, spot.view());
  const std::string file = directory.file("quality.json");
  const ProgramRun ran = run_with({"experiment", "quality", "--image", picture, "--pictures-out",
                                   directory.path().string(), "--out", file});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("| thin_guo_hall | background | spot | 1 | 1 | 0 | 0 |"),
            std::string::npos);
  EXPECT_EQ(read_grey(directory.file("quality_spot_thin_guo_hall.png")).width(), 20);
  EXPECT_EQ(Json::parse(bytes_of(file)).at("command"),
            "thinbench-study experiment quality --image spot.png");
  const ProgramRun dark = run_with({"experiment", "quality", "--image", picture, "--foreground",
                                    "dark", "--threshold", "9", "--out", file});
  EXPECT_NE(dark.out.find("| thin_guo_hall | background | spot | 1 | 1 | 1 | 1 |"),
            std::string::npos);
  EXPECT_EQ(dark.err.find("warning: " + picture + ": 83.5 % of the image is foreground"), 0U);
  EXPECT_EQ(Json::parse(bytes_of(file)).at("command"),
            "thinbench-study experiment quality --image spot.png --foreground dark --threshold 9");
}

}  // namespace
}  // namespace thinbench
