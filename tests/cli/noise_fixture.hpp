// A file with noise, to which commands apply rules.
#pragma once

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "images/image_file.hpp"
#include "program_run.hpp"
#include "support/temporary_directory.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {

using Names = std::set<std::string>;

class NoiseFixture : public testing::Test {
 protected:
  void SetUp() override { write_grey(in, noise().view()); }

  /// 0 and 255.
  static ByteImage noise() {
    ByteImage image = noise_image(203, 70, 50, 4, 7);
    for (Index y = 0; y < image.height(); ++y) {
      for (Index x = 0; x < image.width(); ++x) image.at(x, y) = image.at(x, y) != 0 ? 255 : 0;
    }
    return image;
  }
  static ByteImage applied(const Rule& rule, const Thinning& thinning = {}) {
    ByteImage image = noise();
    thin(rule, image.view(), image.view(), thinning);
    return image;
  }

  /// Foreground is bright, so that nothing is remarked.
  [[nodiscard]] std::vector<std::string> words(const std::string& rule,
                                               std::vector<std::string> more) const {
    more.insert(more.begin(), {"run", rule, in, out, "--foreground", "bright"});
    return more;
  }
  ProgramRun run(const std::string& rule, const std::vector<std::string>& more = {}) const {
    ProgramRun result = run_with(words(rule, more));
    EXPECT_EQ(result.status, 0) << result.err;
    return result;
  }
  [[nodiscard]] bool wrote(const ByteImage& expected) const {
    return equal(read_grey(out).view(), expected.view());
  }

  TemporaryDirectory directory;
  std::string in = directory.file("in.png");
  std::string out = directory.file("out.png");
};

}  // namespace thinbench
