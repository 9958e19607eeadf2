// A directory of three images for tests of the batch command.
#pragma once

#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "images/image_file.hpp"
#include "program_run.hpp"
#include "support/temporary_directory.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {

namespace fs = std::filesystem;
using Names = std::set<std::string>;
using Words = std::vector<std::string>;

/// A bright bar with a hole.
inline ByteImage bar(Index size) {
  ByteImage image(size + 20, 50);
  for (Index y = 5; y < 25; ++y) {
    for (Index x = 5; x < size + 15; ++x) image.at(x, y) = 200;
  }
  image.at(10, 12) = 0;
  return image;
}

inline ByteImage skeleton_of(const ByteImage& grey) {
  ByteImage image = copy_of(grey.view());
  thin(Rule::guo_hall, image.view(), image.view());
  return image;
}

/// All but the seconds, which differ from run to run.
inline std::string without_seconds(const std::string& manifest) {
  return std::regex_replace(manifest, std::regex(R"((,[0-9]+[.e][0-9.e-]+){3},)"), ",s,");
}

class BatchCommand : public testing::Test {
 protected:
  void SetUp() override {
    for (const Index size : {40, 50, 60}) write_bar("in/" + std::to_string(size) + ".png", size);
  }

  void write_bar(const std::string& name, Index size) const {
    fs::create_directories(fs::path(directory.file(name)).parent_path());
    write_grey(directory.file(name), bar(size).view());
  }
  void write_pages(const std::string& name, const std::vector<Index>& sizes) const {
    std::vector<ByteImage> pages;
    for (const Index size : sizes) pages.push_back(bar(size));
    write_grey_pages(directory.file(name), pages);
  }

  [[nodiscard]] Words words(const Words& more, const std::string& operation) const {
    Words all = {"batch", operation, "--out", out};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  [[nodiscard]] ProgramRun run(const Words& more,
                               const std::string& operation = "thin_guo_hall") const {
    return run_with(words(more, operation));
  }
  /// The error message; checks that nothing was written.
  [[nodiscard]] std::string failure(const Words& more, int status,
                                    const std::string& operation = "thin_guo_hall") const {
    std::string text = failure_of(words(more, operation), status);
    EXPECT_FALSE(fs::exists(out));
    return text;
  }

  [[nodiscard]] std::string result(const std::string& name) const { return out + "/" + name; }
  [[nodiscard]] Names results() const {
    Names names;
    for (const auto& entry : fs::recursive_directory_iterator(out)) {
      if (!entry.is_directory()) names.insert(fs::relative(entry.path(), out));
    }
    return names;
  }
  [[nodiscard]] std::string manifest() const { return bytes_of(result("manifest.csv")); }
  void expect_skeleton(const std::string& name, Index size) const {
    EXPECT_TRUE(equal(read_grey(result(name)).view(), skeleton_of(bar(size)).view())) << name;
  }

  TemporaryDirectory directory;
  std::string in = directory.file("in");
  std::string out = directory.file("out");
};

}  // namespace thinbench
