#include "measure/build_facts.hpp"

#include <regex>

#include <gtest/gtest.h>

namespace thinbench {
namespace {

using Json = nlohmann::json;

TEST(BuildFacts, have_the_versions_of_compiler_and_libraries) {
  const Json json = build_facts();
  const std::regex version(R"(\d+\.\d+.*)");
  for (const char* name : {"xsimd", "tbb", "opencv", "benchmark"}) {
    EXPECT_TRUE(std::regex_match(json["libraries"][name].get<std::string>(), version)) << name;
  }
  EXPECT_TRUE(std::regex_match(json["compiler"]["version"].get<std::string>(), version));
  EXPECT_NE(json["compiler"]["id"], "");
  EXPECT_NE(json["compiler"]["flags"].get<std::string>().find("-ffp-contract=off"),
            std::string::npos);
  EXPECT_EQ(json["isa_available"][0], "baseline");
}

}  // namespace
}  // namespace thinbench
