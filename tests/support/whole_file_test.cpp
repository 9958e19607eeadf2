#include "support/whole_file.hpp"

#include <gtest/gtest.h>

#include "support/file_size_limit.hpp"
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

TEST(WholeFile, holds_all_bytes_and_leaves_no_temporary_file) {
  const TemporaryDirectory directory;
  const std::string bytes("a\0b\n", 4);
  write_whole_file(directory.file("a.json"), bytes);
  EXPECT_EQ(bytes_of(directory.file("a.json")), bytes);
  EXPECT_EQ(directory.names(), Names{"a.json"});
}

TEST(WholeFile, replaces_an_existing_file_but_not_a_file_named_part) {
  const TemporaryDirectory directory;
  const std::string file = directory.with("a.json", "old");
  static_cast<void>(directory.with("a.json.part", "unrelated"));
  write_whole_file(file, "new");
  EXPECT_EQ(bytes_of(file), "new");
  EXPECT_EQ(bytes_of(file + ".part"), "unrelated");
}

TEST(WholeFile, explains_why_a_path_cannot_be_written) {
  const TemporaryDirectory directory;
  const std::string absent = directory.file("absent");
  const std::string inside = absent + "/a.json";
  EXPECT_EQ(failure_of(inside),
            "cannot write '" + inside + "': there is no directory '" + absent + "'");
  EXPECT_EQ(failure_of(directory.path().string()),
            "cannot write '" + directory.path().string() + "': it is a directory");
  EXPECT_EQ(failure_of(""), "cannot write '': its name is empty");
}

TEST(WholeFile, failed_write_keeps_the_old_file_and_leaves_no_other) {
  const TemporaryDirectory directory;
  const std::string file = directory.with("a.json", "old");
  {
    const FileSizeLimit limit(100);
    EXPECT_EQ(failure_of(file, std::string(1000, 'x')),
              "cannot write '" + file + "': File too large");
  }
  EXPECT_EQ(bytes_of(file), "old");
  EXPECT_EQ(directory.names(), Names{"a.json"});
}

TEST(WholeFile, abandoned_files_are_removed_but_not_those_being_written) {
  const TemporaryDirectory directory;
  static_cast<void>(directory.with(".thinbench-1", "part"));
  static_cast<void>(directory.with("a.json", "whole"));
  write_whole_file(directory.file("b.json"), [&](const std::string& name) {
    remove_abandoned_files(directory.path().string());
    std::ofstream(name) << "new";
  });
  EXPECT_EQ(directory.names(), (Names{"a.json", "b.json"}));
}

}  // namespace
}  // namespace thinbench
