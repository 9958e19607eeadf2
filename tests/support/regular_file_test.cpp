#include "support/regular_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "support/rejection.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

std::string error_of(const std::string& path) {
  return rejection_of<FileError>([&] { static_cast<void>(read_whole_file(path, 5)); });
}

TEST(RegularFile, is_read_as_a_whole_or_from_its_beginning) {
  const TemporaryDirectory directory;
  const std::string bytes("a\0b\nc", 5);
  const std::string file = directory.with("a", bytes);
  EXPECT_EQ(read_whole_file(file, 5), bytes);
  EXPECT_EQ(beginning_of(file, 3), bytes.substr(0, 3));
  EXPECT_EQ(beginning_of(file, 100), bytes);
  EXPECT_EQ(regular_file_bytes(file), 5);
}

TEST(RegularFile, nothing_else_is_read_nor_waited_for) {
  const TemporaryDirectory directory;
  const std::string pipe = directory.file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0666), 0);
  EXPECT_EQ(error_of(pipe), "cannot read '" + pipe + "': it is not a regular file");
  EXPECT_EQ(error_of("/dev/zero"), "cannot read '/dev/zero': it is not a regular file");
  const std::string name = directory.path().string();
  EXPECT_EQ(error_of(name), "cannot read '" + name + "': it is a directory");
  EXPECT_EQ(error_of(name + "/none"), "cannot read '" + name + "/none': there is no such file");
}

TEST(RegularFile, beyond_a_limit_is_rejected_before_it_is_read) {
  const TemporaryDirectory directory;
  const std::string file = directory.with("a", "");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40);
  EXPECT_EQ(error_of(file), "cannot read '" + file + "': it has more than 5 bytes");
  EXPECT_EQ(rejection_of<FileError>([&] { static_cast<void>(read_whole_file(file, 1'000'000)); }),
            "cannot read '" + file + "': it has more than 1,000,000 bytes");
}

}  // namespace
}  // namespace thinbench
