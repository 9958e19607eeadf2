// Every operation on fixed images, compared with the outputs recorded in golden.tsv.
// With THINBENCH_RECORD_GOLDEN=PATH in the environment, writes the outputs to PATH instead.
#include <cstdlib>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "golden/file.hpp"
#include "golden/images.hpp"
#include "golden/run_case.hpp"

namespace thinbench::golden {
namespace {

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
