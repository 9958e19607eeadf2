#include <cstdint>

#include <gtest/gtest.h>
#include <unistd.h>

#include "images/image_file.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

using Names = std::set<std::string>;

/// A strided, odd-sized image.
ByteImage stripes() {
  ByteImage image(37, 21);
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) image.at(x, y) = (x + y) % 3 == 0 ? 255 : 0;
  }
  return image;
}

void expect_error(const std::string& file, const std::string& reason) {
  try {
    write_grey(file, stripes().view());
    ADD_FAILURE() << file << " was written";
  } catch (const ImageError& error) {
    EXPECT_EQ(std::string(error.what()), "cannot write '" + file + "': " + reason);
  }
}

class WrittenFile : public testing::TestWithParam<const char*> {};

TEST_P(WrittenFile, reads_back_equal_and_is_the_only_file) {
  const TemporaryDirectory directory;
  const std::string name = std::string("a") + GetParam();
  write_grey(directory.file(name), stripes().view());
  EXPECT_TRUE(equal(read_grey(directory.file(name)).view(), stripes().view()));
  EXPECT_EQ(directory.names(), Names{name});
}

INSTANTIATE_TEST_SUITE_P(Extensions, WrittenFile,
                         testing::Values(".png", ".pgm", ".bmp", ".tif", ".tiff", ".PNG"));

TEST(WriteGrey, replaces_a_file) {
  const TemporaryDirectory directory;
  const std::string file = directory.with("a.png", "old");
  write_grey(file, stripes().view());
  EXPECT_TRUE(equal(read_grey(file).view(), stripes().view()));
}

TEST(WriteGrey, unknown_extension_is_rejected_with_the_known_ones) {
  const TemporaryDirectory directory;
  const std::string known = "; known are .png, .pgm, .bmp, .tif and .tiff";
  expect_error(directory.file("a.gif"), "unknown extension '.gif'" + known);
  expect_error(directory.file("a"), "its name has no extension" + known);
  expect_error(directory.file("a.jpg"), "JPEG would change pixels" + known);
  EXPECT_EQ(directory.names(), Names{});
}

TEST(WriteGrey, missing_directory_is_rejected) {
  const TemporaryDirectory directory;
  const std::string absent = directory.file("absent");
  expect_error(absent + "/a.png", "there is no directory '" + absent + "'");
}

TEST(WriteGrey, path_of_a_directory_is_rejected) {
  const TemporaryDirectory directory;
  std::filesystem::create_directory(directory.file("a.png"));
  expect_error(directory.file("a.png"), "it is a directory");
  EXPECT_EQ(directory.names(), Names{"a.png"});
}

TEST(WriteGrey, protected_directory_is_rejected) {
  const TemporaryDirectory directory;
  std::filesystem::permissions(
      directory.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  const bool may_write = access(directory.path().c_str(), W_OK) == 0;
  if (!may_write) expect_error(directory.file("a.png"), "Permission denied");
  std::filesystem::permissions(directory.path(), std::filesystem::perms::owner_all);
  if (may_write) GTEST_SKIP() << "this user may write everywhere";
}

TEST(WriteGrey, directory_without_support_for_files_is_rejected_for_every_user) {
  expect_error("/proc/a.png", "No such file or directory");
}

TEST(WriteGrey, protected_file_is_rejected) {
  const TemporaryDirectory directory;
  const std::string file = directory.with("a.png", "old");
  std::filesystem::permissions(file, std::filesystem::perms::owner_read);
  if (access(file.c_str(), W_OK) == 0) GTEST_SKIP() << "this user may write everything";
  expect_error(file, "it is write-protected");
}

TEST(WriteGrey, full_disk_keeps_the_old_file_and_leaves_no_other) {
  const TemporaryDirectory directory;
  const std::string file = directory.with("a.pgm", "old");
  {
    const FileSizeLimit limit(100);
    expect_error(file, "File too large");
  }
  EXPECT_EQ(bytes_of(file), "old");
  EXPECT_EQ(directory.names(), Names{"a.pgm"});
}

TEST(WriteGrey, image_without_pixels_is_refused) {
  const TemporaryDirectory folder;
  EXPECT_THROW(write_grey(folder.file("a.png"), ByteImage(0, 4).view()), ImageError);
  EXPECT_EQ(folder.names(), Names{});
}

TEST(WriteGrey, accepts_every_size_below_2_to_the_31) {
  EXPECT_TRUE(is_writable_size(715827882, 3));  // 2^31 - 2 pixels
  EXPECT_FALSE(is_writable_size(715827883, 3));
  EXPECT_TRUE(is_writable_size(INT32_MAX, 1));
  EXPECT_FALSE(is_writable_size(Index{1} << 31, 1));
  EXPECT_FALSE(is_writable_size(Index{1} << 16, Index{1} << 15));
  EXPECT_FALSE(is_writable_size(PTRDIFF_MAX, PTRDIFF_MAX));
}

TEST(WriteGrey, size_above_the_limit_is_rejected_before_pixels_are_read) {
  const TemporaryDirectory directory;
  const std::uint8_t pixel = 0;
  const ConstImageView huge{&pixel, Index{1} << 16, Index{1} << 16, Index{1} << 16};
  EXPECT_THROW(write_grey(folder.file("a.png"), huge), ImageError);
  EXPECT_EQ(folder.names(), Names{});
}

}  // namespace
}  // namespace thinbench
