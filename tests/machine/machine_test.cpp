#include "machine/machine.hpp"

#include <cstdlib>
#include <regex>

#include <gtest/gtest.h>

#include "support/temporary_directory.hpp"
#include "thinbench/isa.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

TEST(ReadCpu, reads_the_first_processor) {
  const TemporaryDirectory root;
  static_cast<void>(root.with("proc/cpuinfo",
                              "processor\t: 0\nvendor_id\t: AuthenticAMD\ncpu family\t: 25\n"
                              "model\t\t: 17\nmodel name\t: AMD EPYC\nstepping\t: 1\n"
                              "flags\t\t: sse2 avx2 bmi1\npower management:\n\n"
                              "processor\t: 1\nvendor_id\t: Other\n"));
  const CpuFacts cpu = read_cpu(root.path());
  EXPECT_EQ(cpu.vendor, "amd");
  EXPECT_EQ(cpu.family, "25");
  EXPECT_EQ(cpu.model, "17");
  EXPECT_EQ(cpu.stepping, "1");
  EXPECT_EQ(cpu.name, "AMD EPYC");
  EXPECT_EQ(cpu.flags, (std::vector<std::string>{"avx2", "bmi1", "sse2"}));
}

TEST(ReadFacts, are_unknown_if_no_file_exists) {
  const TemporaryDirectory root;
  const CpuFacts cpu = read_cpu(root.path());
  EXPECT_EQ(cpu.vendor + cpu.family + cpu.model + cpu.stepping + cpu.name,
            "unknownunknownunknownunknownunknown");
  EXPECT_TRUE(cpu.flags.empty());
  EXPECT_EQ(read_caches(root.path()), Json::array());
  EXPECT_EQ(read_memory_gib(root.path()), "unknown");
  EXPECT_EQ(read_os(root.path()), "unknown");
}

TEST(ReadCaches, converts_sizes_to_kib) {
  const TemporaryDirectory root;
  const std::string cache = "sys/devices/system/cpu/cpu0/cache/";
  const char* const facts[][4] = {{"index0", "1\n", "Data\n", "48K\n"},
                                  {"index1", "3\n", "Unified\n", "2M\n"}};
  for (const auto& [index, level, type, size] : facts) {
    static_cast<void>(root.with(cache + index + "/level", level));
    static_cast<void>(root.with(cache + index + "/type", type));
    static_cast<void>(root.with(cache + index + "/size", size));
  }
  EXPECT_EQ(read_caches(root.path()), Json::parse(R"([
      {"level": 1, "type": "Data", "size_kib": 48},
      {"level": 3, "type": "Unified", "size_kib": 2048}])"));
}

TEST(ReadFacts, reads_memory_and_operating_system) {
  const TemporaryDirectory root;
  static_cast<void>(root.with("proc/meminfo", "MemTotal:       16515072 kB\nMemFree: 1 kB\n"));
  static_cast<void>(root.with("etc/os-release", "NAME=\"Some\"\nPRETTY_NAME=\"Some Linux 9\"\n"));
  EXPECT_EQ(read_memory_gib(root.path()), 15.8);
  EXPECT_EQ(read_os(root.path()), "Some Linux 9");
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
  const Json options = {{"quick", true}};
  const Json json = machine_json("abc123", options);
  const std::set<std::string> fields = {
      "schema",   "fingerprint", "cpu",    "cores", "caches",  "memory_gib",    "kernel", "os",
      "compiler", "libraries",   "commit", "date",  "options", "isa_available", "isa_cap"};
  std::set<std::string> found;
  for (const auto& [name, value] : json.items()) found.insert(name);
  EXPECT_EQ(found, fields);
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["commit"], "abc123");
  EXPECT_EQ(json["options"], options);
  EXPECT_GE(json["cores"], 1);
  EXPECT_EQ(json["fingerprint"], machine_fingerprint(read_cpu()));
  EXPECT_EQ(json["isa_available"][0], "baseline");
  EXPECT_TRUE(std::regex_match(json["date"].get<std::string>(),
                               std::regex(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)")));
}

TEST(MachineJson, has_the_versions_of_compiler_and_libraries) {
  const Json json = machine_json("", Json::object());
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
