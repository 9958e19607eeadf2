// A directory of three images for tests of the batch command.
#pragma once

#include <regex>

#include "support/made_image.hpp"
#include "typed.hpp"

namespace thinbench {

/// A bright bar with a hole.
inline ByteImage bar(Index size) {
  return image_by(size + 20, 50, [=](Index x, Index y) {
    const bool hole = x == 10 && y == 12;
    return !hole && x >= 5 && x < size + 15 && y >= 5 && y < 25 ? 200 : 0;
  });
}

inline void write_bar(const std::string& name, Index size) {
  fs::create_directories(fs::absolute(name).parent_path());
  write_grey(name, bar(size).view());
}

inline void write_pages(const std::string& name, const std::vector<Index>& sizes) {
  std::vector<ByteImage> pages;
  for (const Index size : sizes) pages.push_back(bar(size));
  write_grey_pages(name, pages);
}

inline ProgramRun batch(const std::string& operation_and_words) {
  return typed("batch " + operation_and_words + " --out out");
}

/// What a batch prints that must succeed.
inline std::string done(const std::string& operation_and_words) {
  const ProgramRun run = batch(operation_and_words);
  EXPECT_EQ(run.status, 0) << operation_and_words << ": " << run.err;
  return run.out;
}

/// All files in out/.
inline Names results() {
  Names names;
  for (const auto& entry : fs::recursive_directory_iterator("out")) {
    if (!entry.is_directory()) names.insert(fs::relative(entry.path(), "out"));
  }
  return names;
}

inline std::string manifest() {
  return bytes_of("out/manifest.csv");
}

/// All but the seconds, which differ from run to run.
inline std::string without_seconds(const std::string& manifest) {
  const std::string csv =
      std::regex_replace(manifest, std::regex(R"((,[0-9]+[.e][0-9.e-]+){3},)"), ",s,");
  return std::regex_replace(csv, std::regex(R"(seconds":[0-9.e-]+)"), "s");
}

class BatchCommand : public Commands {
 protected:
  BatchCommand() {
    for (const Index size : {40, 50, 60}) write_bar("in/" + std::to_string(size) + ".png", size);
  }
  static void expect_skeleton(const std::string& name, Index size) {
    expect_image("out/" + name, thinned(Rule::guo_hall, bar(size)));
  }
};

}  // namespace thinbench
