#include "support/locked_file.hpp"

#include <atomic>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "support/file_error.hpp"
#include "support/own_directory.hpp"
#include "support/rejection.hpp"

namespace thinbench {
namespace {

using LockedFileTest = OwnDirectory;

TEST_F(LockedFileTest, belongs_to_one_at_a_time) {
  const std::string path = "a";
  const LockedFile first(path, path);
  EXPECT_EQ(rejection_of<FileError>([&] { const LockedFile second(path, path); }),
            "cannot write '" + path + "': another run is writing it");
}

bool is_named(const LockedFile& file, const std::string& path) {
  struct stat opened {};
  struct stat named {};
  return fstat(file.descriptor(), &opened) == 0 && stat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino;
}

/// Replaces the file while it has the lock. Returns how often another file had the name.
int replace_again_and_again(const std::string& path, const std::string& other) {
  int unnamed = 0;
  for (int i = 0; i < 5000; ++i) {
    try {
      const LockedFile file(path, path);
      if (!is_named(file, path)) ++unnamed;
      std::ofstream(other) << "new";
      std::rename(other.c_str(), path.c_str());
    } catch (const FileError&) {  // the other thread has it
    }
  }
  return unnamed;
}

TEST_F(LockedFileTest, has_its_name_even_where_others_replace_it) {
  std::atomic<int> unnamed = 0;
  std::vector<std::thread> threads;
  for (const std::string name : {"b", "c", "d"}) {
    threads.emplace_back([&, name] { unnamed += replace_again_and_again("a", name); });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(unnamed, 0);
}

}  // namespace
}  // namespace thinbench
