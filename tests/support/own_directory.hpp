// Tests that name files without directories.
#pragma once

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "support/temporary_directory.hpp"

namespace thinbench {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// The working directory of each test is empty at first, and is removed at its end.
class OwnDirectory : public testing::Test {
 protected:
  OwnDirectory() { fs::current_path(directory_.path()); }
  ~OwnDirectory() override { fs::current_path(before_); }

  /// Writes a file, creating its directory.
  static void put(const std::string& name, const std::string& bytes) {
    fs::create_directories(fs::absolute(name).parent_path());
    std::ofstream(name, std::ios::binary) << bytes;
  }

  /// Names of all files and directories, hidden ones included.
  [[nodiscard]] Names names() const { return directory_.names(); }

 private:
  fs::path before_ = fs::current_path();
  TemporaryDirectory directory_;
};

}  // namespace thinbench
