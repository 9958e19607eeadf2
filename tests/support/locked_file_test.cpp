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

struct Counts {
  std::atomic<int> locked = 0, unnamed = 0;
};

/// Replaces the file while it has the lock. Counts how often it had it, and how often another file
/// had the name.
void replace_again_and_again(const std::string& path, const std::string& other, Counts& counts) {
  for (int i = 0; i < 5000; ++i) {
    try {
      const LockedFile file(path, path);
      ++counts.locked;
      if (!is_named(file, path)) ++counts.unnamed;
      std::ofstream(other) << "new";
      std::rename(other.c_str(), path.c_str());
    } catch (const FileError&) {  // the other thread has it
    }
  }
}

TEST_F(LockedFileTest, has_its_name_even_where_others_replace_it) {
  Counts counts;
  std::vector<std::thread> threads;
  for (const std::string name : {"b", "c", "d"}) {
    threads.emplace_back([&, name] { replace_again_and_again("a", name, counts); });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(counts.unnamed, 0);
  EXPECT_GT(counts.locked, 0);
}

}  // namespace
}  // namespace thinbench
