#include "support/regular_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "support/own_directory.hpp"
#include "support/rejection.hpp"

namespace thinbench {
namespace {

using RegularFile = OwnDirectory;

std::string error_of(const std::string& path) {
  return rejection_of<FileError>([&] { static_cast<void>(read_whole_file(path, 5)); });
}

TEST_F(RegularFile, is_read_as_a_whole_or_from_its_beginning) {
  const std::string bytes("a\0b\nc", 5);
  put("a", bytes);
  EXPECT_EQ(read_whole_file("a", 5), bytes);
  EXPECT_EQ(beginning_of("a", 3), bytes.substr(0, 3));
  EXPECT_EQ(beginning_of("a", 100), bytes);
  EXPECT_EQ(regular_file_bytes("a"), 5);
}

TEST_F(RegularFile, nothing_else_is_read_nor_waited_for) {
  ASSERT_EQ(mkfifo("pipe", 0666), 0);
  EXPECT_EQ(error_of("pipe"), "cannot read 'pipe': it is not a regular file");
  EXPECT_EQ(error_of("/dev/zero"), "cannot read '/dev/zero': it is not a regular file");
  EXPECT_EQ(error_of("."), "cannot read '.': it is a directory");
  EXPECT_EQ(error_of("none"), "cannot read 'none': there is no such file");
}

TEST_F(RegularFile, beyond_a_limit_is_rejected_before_it_is_read) {
  put("a", "");
  fs::resize_file("a", std::uintmax_t{1} << 40);
  EXPECT_EQ(error_of("a"), "cannot read 'a': it has more than 5 bytes");
  EXPECT_EQ(rejection_of<FileError>([&] { static_cast<void>(read_whole_file("a", 1'000'000)); }),
            "cannot read 'a': it has more than 1,000,000 bytes");
}

}  // namespace
}  // namespace thinbench
