// variants_<processor>.txt records the number of variants per case and ISA, whether or not this
// machine can run them, so that none appears or disappears unnoticed. With
// THINBENCH_RECORD_VARIANTS=PATH in the environment, the numbers are written to PATH instead.
#include <array>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/isas.hpp"
#include "harness/operation.hpp"

namespace thinbench {
namespace {

constexpr const char* kTable =
    THINBENCH_SOURCE_DIR "/tests/harness/variants_" THINBENCH_PROCESSOR ".txt";

/// Numbers of variants, in the order of all_isas().
using Counts = std::array<std::size_t, detail::kIsas.size()>;
/// By case.
using Table = std::map<std::string, Counts>;

std::string header() {
  std::string text;
  for (const Isa isa : all_isas()) text.append(isa_name(isa)).append("\t");
  return text + "cases";
}

/// The technique of each variant at an ISA, peers excluded.
std::vector<std::string> variants_of(const Operation& operation, Isa isa) {
  std::vector<std::string> names;
  for (const Variant& variant : operation.variants) {
    if (variant.isa != isa || variant.is_peer) continue;
    names.push_back(std::string(variant.technique) + (variant.threaded ? " with threads" : ""));
  }
  return names;
}

Table table_of_operations() {
  Table table;
  for (const Operation& operation : all_operations()) {
    for (std::size_t i = 0; i < all_isas().size(); ++i) {
      table[operation.name][i] = variants_of(operation, all_isas()[i]).size();
    }
  }
  return table;
}

/// A line for the cases with the same numbers.
void write_table(const std::string& path, const Table& table) {
  std::map<Counts, std::string> names;
  for (const auto& [name, counts] : table) names[counts] += ' ' + name;
  std::ofstream file(path);
  file << header() << '\n';
  for (const auto& [counts, list] : names) {
    for (const std::size_t count : counts) file << count << '\t';
    file << list.substr(1) << '\n';
  }
}

Table read_table(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, header()) << path;
  Table table;
  while (std::getline(file, line)) {
    std::istringstream columns(line);
    Counts counts{};
    for (std::size_t& count : counts) columns >> count;
    EXPECT_TRUE(columns) << path << ": truncated: " << line;
    for (std::string name; columns >> name;) table[name] = counts;
  }
  return table;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text.append(text.empty() ? "" : ", ").append(name);
  return text.empty() ? "none" : text;
}

/// The variants that a case has lost or gained against the record; empty if none.
std::string difference(const Operation& operation, const Counts& recorded) {
  std::string text;
  for (std::size_t i = 0; i < all_isas().size(); ++i) {
    const std::vector<std::string> names = variants_of(operation, all_isas()[i]);
    if (names.size() == recorded[i]) continue;
    const bool lost = names.size() < recorded[i];
    const std::size_t number = lost ? recorded[i] - names.size() : names.size() - recorded[i];
    text += operation.name + (lost ? " has lost " : " has gained ") + std::to_string(number) +
            " at " + std::string(isa_name(all_isas()[i])) + ", there are " + joined(names) + "\n";
  }
  return text;
}

/// All differences between the operations and the record, one per line.
std::string differences(const std::vector<Operation>& operations, Table recorded) {
  std::string text;
  for (const Operation& operation : operations) {
    const auto line = recorded.extract(operation.name);
    text += line ? difference(operation, line.mapped()) : operation.name + " is not recorded\n";
  }
  for (const auto& [name, counts] : recorded) text += name + " is no longer there\n";
  return text;
}

TEST(Variants, numbers_equal_the_recorded_ones) {
  if (const char* path = std::getenv("THINBENCH_RECORD_VARIANTS"); path != nullptr && *path != 0) {
    write_table(path, table_of_operations());
    GTEST_SKIP() << "recorded";
  }
  EXPECT_EQ(differences(all_operations(), read_table(kTable)), "");
}

Operation operation_with(const std::string& name, const std::vector<Isa>& isas) {
  Operation operation = {name, "", InputKind::binary, {}, {}};
  for (const Isa isa : isas) operation.variants.push_back({"lut", "", isa, false, true, {}, {}});
  return operation;
}

TEST(Variants, lost_and_gained_variants_are_reported_by_case) {
  const std::vector<Operation> operations = {
      operation_with("thin_a", {}), operation_with("thin_b", {Isa::baseline, Isa::baseline}),
      operation_with("thin_b:keep", {Isa::baseline})};
  EXPECT_EQ(differences(operations, {{"thin_a", {0}}, {"thin_b", {2}}, {"thin_b:keep", {1}}}), "");
  EXPECT_EQ(differences(operations, {{"thin_a", {1}}, {"thin_b", {1}}, {"thin_c", {1}}}),
            "thin_a has lost 1 at baseline, there are none\n"
            "thin_b has gained 1 at baseline, there are lut, lut\n"
            "thin_b:keep is not recorded\n"
            "thin_c is no longer there\n");
}

}  // namespace
}  // namespace thinbench
