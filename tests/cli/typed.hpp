// Command lines of `thinbench`, typed in a directory of their own, inside the test process.
#pragma once

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/thinbench.hpp"
#include "images/image_file.hpp"
#include "support/captured_run.hpp"
#include "support/own_directory.hpp"

namespace thinbench {

inline ProgramRun typed(const std::string& line) {
  return captured_run(thinbench_program(), words_of(line));
}

/// What a command prints that must succeed.
inline std::string output_of(const std::string& line) {
  const ProgramRun run = typed(line);
  EXPECT_EQ(run.status, 0) << line << ": " << run.err;
  return run.out;
}

inline void expect_holds(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << " in:\n" << text;
}

/// A command that must fail with one line that holds these parts, print nothing and leave no file.
struct Rejection {
  int status;  // 1: what the words name cannot be done; 2: the words are wrong
  std::string line;
  std::vector<std::string> parts;
};

inline void expect_rejected(const Rejection& rejection) {
  SCOPED_TRACE(rejection.line);
  const auto files = [] {
    const fs::recursive_directory_iterator all(".");
    return std::set<fs::path>(begin(all), end(all));
  };
  const std::set<fs::path> before = files();
  const ProgramRun run = typed(rejection.line);
  EXPECT_EQ(run.status, rejection.status);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err.rfind("thinbench: ", 0), 0U);
  EXPECT_EQ(run.err.find('\n') + 1, run.err.size()) << run.err;
  for (const std::string& part : rejection.parts) expect_holds(run.err, part);
  EXPECT_EQ(files(), before);
}

inline void expect_rejected(const std::vector<Rejection>& rejections) {
  for (const Rejection& rejection : rejections) expect_rejected(rejection);
}

class Commands : public OwnDirectory {
 protected:
  static void expect_image(const std::string& file, const ByteImage& expected) {
    EXPECT_TRUE(equal(read_grey(file).view(), expected.view())) << file;
  }
};

}  // namespace thinbench
