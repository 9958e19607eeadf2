#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "picture/picture.hpp"
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
  for (const char* name :
       {"cluster-runs", "literal-holes", "quantisation", "operation-counts", "table-2"}) {
    EXPECT_NE(run_with({"experiment", name}).out.find("| --- |"), std::string::npos) << name;
  }
  const ProgramRun ran = run_with({"experiment", "hidden-neurons", "--quick"});
  EXPECT_NE(ran.out.find("| 12 | 256 |"), std::string::npos) << ran.out;
  EXPECT_NE(ran.err.find("hidden neurons: 91 %"), std::string::npos) << ran.err;
}

constexpr const char* kHeader = "operation,technique,isa,threads,scope,input,median_ns\n";

TEST(ExperimentCommand, table_2_compares_the_times_of_a_results_directory_with_the_paper) {
  const TemporaryDirectory directory;
  static_cast<void>(directory.with(
      "timings.csv", std::string(kHeader) +
                         "thin_naccache_shinghal,reference,baseline,1,end_to_end,scene,9000\n"
                         "thin_naccache_shinghal,lut,baseline,1,end_to_end,scene,3000\n"
                         "thin_naccache_shinghal,simd_bytes,avx2,1,end_to_end,scene,2000\n"
                         "thin_naccache_shinghal,simd_bytes,avx2,1,kernel,scene,1\n"
                         "thin_naccache_shinghal,simd_bytes,avx2,2,end_to_end,scene,1\n"
                         "thin_naccache_shinghal,simd_bytes,avx2,1,end_to_end,square_64,1\n"
                         "net_two_layer_linear,reference,baseline,1,end_to_end,scene,45000\n"
                         "net_two_layer_linear,lut,baseline,1,end_to_end,scene,5000\n"));
  const std::string file = directory.file("table.json");
  const ProgramRun ran =
      run_with({"experiment", "table-2", "--results", directory.path().string(), "--out", file});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("| 0.73 | 1.00 | 9.0 | 1.00 | simd_bytes (avx2) | 2.0 | 1.00 |"),
            std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("| 3.54 | 4.85 | 45.0 | 5.00 | lut (baseline) | 5.0 | 2.50 |"),
            std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("| 5.11 | 7.00 |  |  |  |  |  |"), std::string::npos) << ran.out;
  const Json json = Json::parse(bytes_of(file));
  EXPECT_EQ(json.at("/rows/4/best_ratio"_json_pointer), 2.5);
  EXPECT_EQ(json.at("command"),
            "thinbench experiment table-2 --results " + directory.path().string());
}

TEST(ExperimentCommand, table_2_rejects_directories_without_valid_results) {
  const TemporaryDirectory directory;
  const std::string csv = directory.file("timings.csv");
  const std::vector<std::string> args = {"experiment", "table-2", "--results",
                                         directory.path().string()};
  EXPECT_EQ(failure_of(args, 1), "cannot read '" + csv + "'");
  static_cast<void>(directory.with("timings.csv", "operation,technique\n"));
  EXPECT_EQ(failure_of(args, 1), csv + ": has no column isa");
  static_cast<void>(directory.with("timings.csv", std::string(kHeader) + "a,b,c\n"));
  EXPECT_EQ(failure_of(args, 1), csv + ": line 2 is truncated");
  static_cast<void>(
      directory.with("timings.csv", std::string(kHeader) + "a,b,c,1,end_to_end,scene,fast\n"));
  EXPECT_EQ(failure_of(args, 1), csv + ": line 2: 'fast' is no time");
}

TEST(ExperimentCommand, quality_reads_images_and_writes_skeletons) {
  const TemporaryDirectory directory;
  const std::string image = directory.file("spot.png");
  ByteImage spot(20, 10);
  for (Index x = 4; x < 15; ++x) spot.at(x, 5) = spot.at(x, 6) = spot.at(x, 7) = 255;
  write_grey(image, spot.view());
  const std::string file = directory.file("quality.json");
  const ProgramRun ran = run_with({"experiment", "quality", "--image", image, "--pictures-out",
                                   directory.path().string(), "--out", file});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("| spot | thin_guo_hall | 1 to 1 | 0 to 0 |"), std::string::npos);
  EXPECT_EQ(read_grey(directory.file("quality_spot_thin_guo_hall.png")).width(), 20);
  EXPECT_EQ(Json::parse(bytes_of(file)).at("command"),
            "thinbench experiment quality --image spot.png");
  const ProgramRun dark = run_with({"experiment", "quality", "--image", image, "--foreground",
                                    "dark", "--threshold", "9", "--out", file});
  EXPECT_NE(dark.out.find("| spot | thin_guo_hall | 1 to 1 | 1 to 1 |"), std::string::npos);
  EXPECT_EQ(dark.err.find("warning: " + image + ": 83.5 % of the image is foreground"), 0U);
  EXPECT_EQ(Json::parse(bytes_of(file)).at("command"),
            "thinbench experiment quality --image spot.png --foreground dark --threshold 9");
  EXPECT_EQ(failure_of({"experiment", "quality", "--image", "absent.png"}, 1),
            "cannot read 'absent.png': there is no such file");
}

TEST(ExperimentCommand, unwritable_files_are_rejected_before_the_experiment) {
  EXPECT_EQ(failure_of({"experiment", "hidden-neurons", "--out", "no_such_folder/x.json"}, 1),
            "cannot write 'no_such_folder/x.json': there is no directory 'no_such_folder'");
}

}  // namespace
}  // namespace thinbench
