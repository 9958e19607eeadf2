#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "program_run.hpp"

namespace thinbench {
namespace {

std::string checked_in() {
  std::ifstream file(THINBENCH_SOURCE_DIR "/kernels/rules/built_in/circuits.hpp");
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The circuits of a header, and what stands before and after them.
std::vector<std::string> parts_of(const std::string& header) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from < header.size();) {
    const std::size_t end = std::min(header.find("\n\n", from), header.size());
    parts.push_back(header.substr(from, end - from));
    from = end + 2;
  }
  return parts;
}

void expect_checked_in(const ProgramRun& run, std::size_t circuits) {
  constexpr std::size_t kOtherParts = 6;
  ASSERT_EQ(run.status, 0) << run.err;
  const std::vector<std::string> known = parts_of(checked_in());
  const std::vector<std::string> printed = parts_of(run.out);
  EXPECT_EQ(printed.size(), kOtherParts + circuits);
  for (const std::string& part : printed) {
    EXPECT_NE(std::find(known.begin(), known.end(), part), known.end()) << part;
  }
}

TEST(CircuitsCommand, finds_the_circuits_that_are_checked_in) {
  expect_checked_in(run_with({"circuits", "spta_directional", "naccache_shinghal"}), 4);
}

TEST(CircuitsCommand, keeps_circuits_where_a_search_finds_none_with_fewer_gates) {
  expect_checked_in(
      run_with({"circuits", "spta_directional", "naccache_shinghal", "--effort", "10"}), 4);
}

}  // namespace
}  // namespace thinbench
