#include "support/file_bytes.hpp"

#include <chrono>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/own_directory.hpp"
#include "support/rejection.hpp"
#include "support/text.hpp"

namespace thinbench {
namespace {

using FileBytesTest = OwnDirectory;

std::string error_of(const std::string& path) {
  return rejection_of<FileError>([&] { static_cast<void>(read_file(path, 5)); });
}

TEST_F(FileBytesTest, hold_all_bytes) {
  const std::string bytes("a\0b\nc", 5);
  put("a", bytes);
  EXPECT_EQ(read_file("a", 5).text(), bytes);
  EXPECT_EQ(read_file("a").name(), "a");
  put("empty", "");
  EXPECT_EQ(read_file("empty").text(), "");
}

TEST_F(FileBytesTest, nothing_but_regular_files_is_read_nor_waited_for) {
  ASSERT_EQ(mkfifo("pipe", 0666), 0);
  EXPECT_EQ(error_of("pipe"), "cannot read 'pipe': it is not a regular file");
  EXPECT_EQ(error_of("/dev/zero"), "cannot read '/dev/zero': it is not a regular file");
  EXPECT_EQ(error_of("."), "cannot read '.': it is a directory");
  EXPECT_EQ(error_of("none"), "cannot read 'none': there is no such file");
}

TEST_F(FileBytesTest, beyond_a_limit_is_rejected_before_it_is_read) {
  put("a", "");
  fs::resize_file("a", std::uintmax_t{1} << 40);
  EXPECT_EQ(error_of("a"), "cannot read 'a': it has more than 5 bytes");
  EXPECT_EQ(rejection_of<FileError>([&] { static_cast<void>(read_file("a", 1'000'000)); }),
            "cannot read 'a': it has more than 1,000,000 bytes");
}

TEST(ExtensionOf, is_in_lower_case_whatever_the_name_has) {
  EXPECT_EQ(extension_of("page.tif"), ".tif");
  EXPECT_EQ(extension_of("SCANS.D/PAGE.TIFF"), ".tiff");
  EXPECT_EQ(extension_of("a.b.Pbm"), ".pbm");
  EXPECT_EQ(extension_of("scans.d/page"), "");
}

}  // namespace
}  // namespace thinbench
