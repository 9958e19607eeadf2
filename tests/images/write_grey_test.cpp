#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include <gtest/gtest.h>
#include <unistd.h>

#include "images/image_file.hpp"
#include "support/made_image.hpp"
#include "support/own_directory.hpp"
#include "support/rejection.hpp"

namespace thinbench {
namespace {

/// An odd-sized image.
ByteImage stripes() {
  return image_by(37, 21, [](Index x, Index y) { return (x + y) % 3 == 0 ? 255 : 0; });
}

void expect_error(const std::string& file, const std::string& reason) {
  EXPECT_EQ(rejection_of<FileError>([&] { write_grey(file, stripes().view()); }),
            "cannot write '" + file + "': " + reason);
}

using WriteGrey = OwnDirectory;

TEST_F(WriteGrey, files_of_every_format_read_back_equal_and_replace_what_was_there) {
  put("a.png", "old");
  for (const std::string name : {"a.png", "a.pgm", "a.bmp", "a.tif", "a.tiff", "b.PNG"}) {
    write_grey(name, stripes().view());
    EXPECT_TRUE(equal(read_grey(name).view(), stripes().view())) << name;
  }
  EXPECT_EQ(names(), (Names{"a.png", "a.pgm", "a.bmp", "a.tif", "a.tiff", "b.PNG"}));
}

TEST_F(WriteGrey, one_and_several_pages_are_written_through_a_link_whatever_the_target_is_called) {
  fs::create_symlink("target", "a.tif");
  write_grey("a.tif", stripes().view());
  EXPECT_EQ(pages_in(read_file("target")).size(), 1);
  std::vector<ByteImage> pages(2);
  for (ByteImage& page : pages) page = stripes();
  write_grey_pages("a.tif", pages);
  EXPECT_EQ(pages_in(read_file("target")).size(), 2);
  EXPECT_EQ(names(), (Names{"a.tif", "target"}));
}

TEST_F(WriteGrey, names_that_cannot_be_written_are_rejected_with_the_reason) {
  const std::string known = "; known are .png, .pgm, .bmp, .tif and .tiff";
  expect_error("a.gif", "unknown extension '.gif'" + known);
  expect_error("a", "its name has no extension" + known);
  expect_error("a.jpg", "JPEG would change pixels" + known);
  expect_error("absent/a.png", "there is no directory 'absent'");
  expect_error("/proc/a.png", "No such file or directory");  // for every user
  fs::create_directory("a.png");
  expect_error("a.png", "it is a directory");
  EXPECT_EQ(names(), Names{"a.png"});
}

constexpr uid_t kUnprivileged = 65534;

TEST_F(WriteGrey, what_is_protected_is_rejected) {
  put("a.png", "old");
  fs::permissions("a.png", fs::perms::owner_read);
  fs::create_directory("b");
  fs::permissions("b", fs::perms::owner_read | fs::perms::owner_exec);
  fs::permissions(".", fs::perms::all);
  const auto rejected = [] {
    if (geteuid() == 0 && setuid(kUnprivileged) != 0) std::_Exit(2);  // root may write everything
    expect_error("a.png", "it is write-protected");
    expect_error("b/a.png", "Permission denied");
    std::_Exit(HasFailure() ? 1 : 0);
  };
  EXPECT_EXIT(rejected(), testing::ExitedWithCode(0), "");
}

TEST_F(WriteGrey, sizes_beyond_the_limits_are_rejected_before_a_pixel_is_touched) {
  const std::uint8_t pixel = 0;
  const ConstImageView huge{&pixel, Index{1} << 16, Index{1} << 16, Index{1} << 16};
  EXPECT_THROW(write_grey("a.png", huge), FileError);
  EXPECT_THROW(write_grey("a.png", {&pixel, 715827883, 3}), FileError);  // 2^31 + 1
  EXPECT_THROW(write_grey("a.png", {&pixel, PTRDIFF_MAX, PTRDIFF_MAX}), FileError);
  EXPECT_THROW(write_grey("a.png", ByteImage(0, 4).view()), FileError);
  EXPECT_EQ(names(), Names{});
}

TEST_F(WriteGrey, labels_beyond_16_bits_take_32_in_tiff_and_nothing_else) {
  const std::int32_t labels[] = {0, 7, 65536, INT32_MAX};
  write_labels("a.tif", {labels, 2, 2});
  EXPECT_EQ(read_labels(read_file("a.tif")).labels, std::vector<std::int32_t>(labels, labels + 4));
  EXPECT_EQ(
      rejection_of<FileError>([&] {
        write_labels("a.png", {labels, 2, 2});
      }),
      "cannot write 'a.png': it has labels up to 2147483647, and its format holds 65535; .tif "
      "holds more");
  write_labels("a.png", {labels, 2, 1});
  EXPECT_EQ(read_labels(read_file("a.png")).labels, std::vector<std::int32_t>(labels, labels + 2));
}

TEST_F(WriteGrey, real_numbers_are_written_as_they_are) {
  const float numbers[] = {0, 0.25F, 3, 1e30F};
  write_reals("a.tif", {numbers, 4, 1});
  const Pixels read = decode(read_file("a.tif"));
  EXPECT_EQ(read.kind, SampleKind::f32);
  EXPECT_TRUE(std::equal(numbers, numbers + 4, read.samples_of_row<float>(0)));
  EXPECT_THROW(write_reals("a.png", {numbers, 4, 1}), ExtensionError);
}

TEST_F(WriteGrey, an_image_too_wide_for_png_names_other_formats) {
  const ByteImage wide(1'000'500, 1);
  EXPECT_EQ(rejection_of<FileError>([&] { write_grey("a.png", wide.view()); }),
            "cannot write 'a.png': PNG has sides of at most 10^6 pixels; .tif and .pgm have no "
            "such limit");
  for (const char* name : {"a.tif", "a.pgm"}) {
    write_grey(name, wide.view());
    EXPECT_EQ(read_grey(name).width(), 1'000'500);
  }
}

}  // namespace
}  // namespace thinbench
