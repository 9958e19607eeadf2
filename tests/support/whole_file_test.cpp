#include "support/whole_file.hpp"

#include <csignal>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

using Names = std::set<std::string>;

std::string failure_of(const std::string& path, const std::string& bytes = "new") {
  try {
    write_whole_file(path, bytes);
  } catch (const FileError& error) {
    return error.what();
  }
  return "written";
}

TEST(WholeFile, appears_with_all_its_bytes_and_alone) {
  const TemporaryDirectory folder;
  const std::string bytes("a\0b\n", 4);
  write_whole_file(folder.file("a.json"), bytes);
  EXPECT_EQ(bytes_of(folder.file("a.json")), bytes);
  EXPECT_EQ(folder.names(), Names{"a.json"});
}

TEST(WholeFile, replaces_a_file_and_leaves_a_neighbour_called_part_alone) {
  const TemporaryDirectory folder;
  const std::string file = folder.with("a.json", "old");
  static_cast<void>(folder.with("a.json.part", "somebody's"));
  write_whole_file(file, "new");
  EXPECT_EQ(bytes_of(file), "new");
  EXPECT_EQ(bytes_of(file + ".part"), "somebody's");
}

TEST(WholeFile, names_what_is_in_the_way) {
  const TemporaryDirectory folder;
  const std::string absent = folder.file("absent");
  const std::string inside = absent + "/a.json";
  EXPECT_EQ(failure_of(inside),
            "cannot write '" + inside + "': there is no directory '" + absent + "'");
  EXPECT_EQ(failure_of(folder.path().string()),
            "cannot write '" + folder.path().string() + "': it is a directory");
  EXPECT_EQ(failure_of(""), "cannot write '': its name is empty");
}

TEST(WholeFile, failure_on_the_way_leaves_the_old_file_and_nothing_else) {
  const TemporaryDirectory folder;
  const std::string file = folder.with("a.json", "old");
  auto* const handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const rlimit small{100, old.rlim_max};  // as on a full disk
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string failure = failure_of(file, std::string(1000, 'x'));
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(failure, "cannot write '" + file + "': File too large");
  EXPECT_EQ(bytes_of(file), "old");
  EXPECT_EQ(folder.names(), Names{"a.json"});
}

}  // namespace
}  // namespace thinbench
