// Every operation on fixed images, compared with the outputs recorded in golden.tsv.
// With THINBENCH_RECORD_GOLDEN=PATH in the environment, writes the outputs to PATH instead.
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "golden/images.hpp"
#include "golden/run_case.hpp"

namespace thinbench::golden {
namespace {

/// The golden file: tab-separated text. The header names the images; each line is an operation with
/// its options, sorted, and has a result per image.
constexpr const char* kHeader = "operation\tborder";

constexpr const char* kNone = "-";  // the operation has no such input

using Recorded = std::map<Case, Result>;

void write_golden(const std::string& path, const Recorded& recorded) {
  std::set<std::string> images;
  for (const auto& [one, result] : recorded) images.insert(one.image);
  std::ofstream file(path);
  file << kHeader;
  for (const std::string& image : images) file << '\t' << image;
  for (auto row = recorded.begin(); row != recorded.end();) {
    Case one = row->first;
    file << '\n' << one.operation << '\t' << one.border;
    for (const std::string& image : images) {
      one.image = image;
      const auto found = recorded.find(one);
      file << '\t' << (found == recorded.end() ? kNone : found->second);
    }
    row = recorded.upper_bound(one);
  }
  if (!(file << '\n').flush()) throw std::runtime_error("cannot write " + path);
}

/// Throws std::runtime_error if the file is missing or has another header, or if a line has fewer
/// results than the header has images.
Recorded read_golden(const std::string& path) {
  std::ifstream file(path);
  std::string line, name;
  if (!std::getline(file, line) || !line.starts_with(kHeader)) {
    throw std::runtime_error("no header: " + path);
  }
  std::istringstream names(line.substr(std::string(kHeader).size()));
  std::vector<std::string> images;
  while (names >> name) images.push_back(name);
  Recorded recorded;
  while (std::getline(file, line)) {
    std::istringstream columns(line);
    Case one;
    columns >> one.operation >> one.border;
    for (const std::string& image : images) {
      Result result;
      if (!(columns >> result)) throw std::runtime_error("truncated: " + line);
      one.image = image;
      if (result != kNone) recorded[one] = result;
    }
  }
  return recorded;
}

constexpr std::size_t kMinCases = 1512;
constexpr Index kMaxPixelsForReferences = 50'000;

const std::map<std::string, TestImage>& images_by_name() {
  static const std::map<std::string, TestImage> images = [] {
    std::map<std::string, TestImage> by_name;
    for (TestImage& one : golden_images()) {
      const std::string name = one.name;
      by_name.emplace(name, std::move(one));
    }
    return by_name;
  }();
  return images;
}

std::string text_of(const Case& one) {
  return one.operation + ", border " + one.border + ", image " + one.image;
}

void expect_recorded(const Case& one, const Result& recorded) {
  const auto found = images_by_name().find(one.image);
  ASSERT_NE(found, images_by_name().end()) << "no such image: " << text_of(one);
  const ByteImage& image = found->second.image;
  for (const int threads : {1, 3}) {
    EXPECT_EQ(run_case(one, image, threads), recorded) << text_of(one) << ", threads " << threads;
  }
}

Recorded results_of_all_cases() {
  Recorded results;
  for (const auto& [name, image] : images_by_name()) {
    for (const Case& one : cases_on(name, image.kind)) {
      results[one] = run_case(one, image.image, 1);
    }
  }
  return results;
}

Recorded golden_file() {
  return read_golden(THINBENCH_SOURCE_DIR "/tests/golden/golden.tsv");
}

TEST(Golden, outputs_equal_the_recorded_ones) {
  if (const char* path = std::getenv("THINBENCH_RECORD_GOLDEN"); path != nullptr) {
    const Recorded results = results_of_all_cases();
    write_golden(path, results);
    GTEST_SKIP() << results.size() << " cases recorded";
  }
  const Recorded recorded = golden_file();
  EXPECT_GE(recorded.size(), kMinCases);
  for (const auto& [one, result] : recorded) expect_recorded(one, result);
}

TEST(Golden, thinning_references_equal_the_recorded_outputs_on_small_images) {
  for (const auto& [one, result] : golden_file()) {
    const auto found = images_by_name().find(one.image);
    if (one.border == "-" || found == images_by_name().end()) continue;
    const ByteImage& image = found->second.image;
    if (image.width() * image.height() > kMaxPixelsForReferences) continue;
    EXPECT_EQ(run_reference(one, image), result) << text_of(one);
  }
}

}  // namespace
}  // namespace thinbench::golden
