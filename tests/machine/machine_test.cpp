#include "machine/machine.hpp"

#include <cstdlib>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "thinbench/isa.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

TEST(CpuFacts, are_those_of_lscpu) {
  const CpuFacts cpu = cpu_facts_from(R"({"lscpu": [
      {"field": "Vendor ID:", "data": "AuthenticAMD"}, {"field": "Model name:", "data": "AMD EPYC"},
      {"field": "CPU family:", "data": "25"}, {"field": "Model:", "data": "17"},
      {"field": "Stepping:", "data": "1"}, {"field": "Flags:", "data": "sse2 avx2 bmi1"}]})");
  EXPECT_EQ(cpu.vendor, "amd");
  EXPECT_EQ(cpu.family, "25");
  EXPECT_EQ(cpu.model, "17");
  EXPECT_EQ(cpu.stepping, "1");
  EXPECT_EQ(cpu.name, "AMD EPYC");
  EXPECT_EQ(cpu.flags, (std::vector<std::string>{"avx2", "bmi1", "sse2"}));
}

TEST(CpuFacts, are_unknown_without_lscpu) {
  const CpuFacts cpu = cpu_facts_from("");
  EXPECT_EQ(cpu.vendor + cpu.family + cpu.model + cpu.stepping + cpu.name,
            "unknownunknownunknownunknownunknown");
  EXPECT_TRUE(cpu.flags.empty());
  EXPECT_EQ(caches_from(""), Json::array());
}

TEST(Caches, are_in_kib) {
  EXPECT_EQ(
      caches_from(R"({"caches": [{"name": "L1d", "one-size": "49152", "type": "Data", "level": 1},
                {"name": "L3", "one-size": "2097152", "type": "Unified", "level": 3}]})"),
      Json::parse(R"([{"level": 1, "type": "Data", "size_kib": 48},
                            {"level": 3, "type": "Unified", "size_kib": 2048}])"));
}

TEST(Fingerprint, consists_of_the_processor_and_a_hash) {
  const std::string text = machine_fingerprint({"intel", "6", "143", "8", "Xeon", {"avx2"}});
  EXPECT_TRUE(std::regex_match(text, std::regex("intel-6-143-8-[0-9a-f]{8}"))) << text;
}

TEST(Fingerprint, depends_on_the_flags_but_not_on_the_name) {
  const CpuFacts cpu{"intel", "6", "143", "8", "Xeon", {"avx2", "bmi1"}};
  CpuFacts other = cpu;
  other.name = "another name";
  EXPECT_EQ(machine_fingerprint(cpu), machine_fingerprint(other));
  other.flags = {"avx2"};
  EXPECT_NE(machine_fingerprint(cpu), machine_fingerprint(other));
}

TEST(MachineJson, has_every_field_of_the_schema) {
  const Json json = machine_json();
  const std::set<std::string> fields = {
      "schema", "fingerprint", "cpu",       "cores", "caches",        "memory_gib", "kernel",
      "os",     "compiler",    "libraries", "date",  "isa_available", "isa_cap"};
  std::set<std::string> found;
  for (const auto& [name, value] : json.items()) found.insert(name);
  EXPECT_EQ(found, fields);
  EXPECT_EQ(json["schema"], 1);
  EXPECT_GE(json["cores"], 1);
  EXPECT_EQ(json["fingerprint"], machine_fingerprint());
  EXPECT_EQ(json["isa_available"][0], "baseline");
  EXPECT_TRUE(std::regex_match(json["date"].get<std::string>(),
                               std::regex(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)")));
}

TEST(MachineJson, has_the_versions_of_compiler_and_libraries) {
  const Json json = machine_json();
  const std::regex version(R"(\d+\.\d+.*)");
  for (const char* name : {"xsimd", "tbb", "opencv", "benchmark"}) {
    EXPECT_TRUE(std::regex_match(json["libraries"][name].get<std::string>(), version)) << name;
  }
  EXPECT_TRUE(std::regex_match(json["compiler"]["version"].get<std::string>(), version));
  EXPECT_NE(json["compiler"]["id"], "");
  EXPECT_NE(json["compiler"]["flags"].get<std::string>().find("-ffp-contract=off"),
            std::string::npos);
}

}  // namespace
}  // namespace thinbench
