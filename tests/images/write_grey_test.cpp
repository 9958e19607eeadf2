#include <csignal>
#include <cstdint>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "images/image_file.hpp"
#include "support/rejection.hpp"
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
    } catch (const FileError& error) {
      EXPECT_EQ(std::string(error.what()), "cannot write '" + file + "': " + reason);
    }
  }

  /// Files cannot grow beyond some bytes while it lives, as on a full disk.
  class FullDisk {
   public:
    explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
      getrlimit(RLIMIT_FSIZE, &old_);
      const rlimit small{bytes, old_.rlim_max};
      setrlimit(RLIMIT_FSIZE, &small);
    }
    ~FullDisk() {
      setrlimit(RLIMIT_FSIZE, &old_);
      std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;
    FullDisk(FullDisk&&) = delete;
    FullDisk& operator=(FullDisk&&) = delete;

   private:
    rlimit old_{};
    void (*handler_)(int);
  };

  class WrittenFile : public testing::TestWithParam<const char*> {};

  TEST_P(WrittenFile, reads_back_equal_and_lies_alone_in_its_directory) {
    const TemporaryDirectory directory;
    const std::string name = std::string("a") + GetParam();
    write_grey(directory.file(name), stripes().view());
    EXPECT_TRUE(equal(read_grey(directory.file(name)).view(), stripes().view()));
    EXPECT_EQ(directory.names(), Names{name});
  }

  INSTANTIATE_TEST_SUITE_P(Endings, WrittenFile,
                           testing::Values(".png", ".pgm", ".bmp", ".tif", ".tiff", ".PNG"));

  TEST(WriteGrey, replaces_a_file) {
    const TemporaryDirectory directory;
    const std::string file = directory.with("a.png", "old");
    write_grey(file, stripes().view());
    EXPECT_TRUE(equal(read_grey(file).view(), stripes().view()));
  }

  TEST(WriteGrey, one_and_several_pages_are_written_through_a_link_whatever_the_target_is_called) {
    const TemporaryDirectory directory;
    const std::string link = directory.file("a.tif");
    std::filesystem::create_symlink("target", link);
    write_grey(link, stripes().view());
    EXPECT_EQ(page_count(directory.file("target")), 1);
    std::vector<ByteImage> pages(2);
    for (ByteImage& page : pages) page = stripes();
    write_grey_pages(link, pages);
    EXPECT_EQ(page_count(directory.file("target")), 2);
    EXPECT_EQ(directory.names(), (Names{"a.tif", "target"}));
  }

  TEST(WriteGrey, unknown_ending_names_the_known_ones) {
    const TemporaryDirectory directory;
    const std::string known = "; known are .png, .pgm, .bmp, .tif and .tiff";
    expect_error(directory.file("a.gif"), "unknown extension '.gif'" + known);
    expect_error(directory.file("a"), "its name has no extension" + known);
    expect_error(directory.file("a.jpg"), "JPEG would change pixels" + known);
    EXPECT_EQ(directory.names(), Names{});
  }

  TEST(WriteGrey, absent_directory_is_named) {
    const TemporaryDirectory directory;
    const std::string absent = directory.file("absent");
    expect_error(absent + "/a.png", "there is no directory '" + absent + "'");
  }

  TEST(WriteGrey, directory_in_the_way_is_rejected) {
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

  TEST(WriteGrey, directory_that_takes_no_files_is_rejected_for_every_user) {
    expect_error("/proc/a.png", "No such file or directory");
  }

  TEST(WriteGrey, protected_file_is_rejected) {
    const TemporaryDirectory directory;
    const std::string file = directory.with("a.png", "old");
    std::filesystem::permissions(file, std::filesystem::perms::owner_read);
    if (access(file.c_str(), W_OK) == 0) GTEST_SKIP() << "this user may write everything";
    expect_error(file, "it is write-protected");
  }

  TEST(WriteGrey, full_disk_leaves_the_old_file_and_nothing_else) {
    const TemporaryDirectory directory;
    const std::string file = directory.with("a.pgm", "old");
    {
      const FullDisk full(100);
      expect_error(file, "File too large");
    }
    EXPECT_EQ(bytes_of(file), "old");
    EXPECT_EQ(directory.names(), Names{"a.pgm"});
  }

  TEST(WriteGrey, image_without_pixels_is_rejected) {
    const TemporaryDirectory directory;
    EXPECT_THROW(write_grey(directory.file("a.png"), ByteImage(0, 4).view()), FileError);
    EXPECT_EQ(directory.names(), Names{});
  }

  TEST(WriteGrey, takes_every_size_below_two_to_the_31) {
    EXPECT_TRUE(is_writable_size(715827882, 3));  // 2^31 - 2 pixels
    EXPECT_FALSE(is_writable_size(715827883, 3));
    EXPECT_TRUE(is_writable_size(INT32_MAX, 1));
    EXPECT_FALSE(is_writable_size(Index{1} << 31, 1));
    EXPECT_FALSE(is_writable_size(Index{1} << 16, Index{1} << 15));
    EXPECT_FALSE(is_writable_size(PTRDIFF_MAX, PTRDIFF_MAX));
  }

  TEST(WriteGrey, size_beyond_the_limit_is_rejected_before_a_pixel_is_touched) {
    const TemporaryDirectory directory;
    const std::uint8_t pixel = 0;
    const ConstImageView huge{&pixel, Index{1} << 16, Index{1} << 16, Index{1} << 16};
    EXPECT_THROW(write_grey(directory.file("a.png"), huge), FileError);
    EXPECT_EQ(directory.names(), Names{});
  }

  TEST(WriteGrey, an_image_too_wide_for_png_names_other_formats) {
    const TemporaryDirectory directory;
    const ByteImage wide(1'000'500, 1);
    EXPECT_EQ(rejection_of<FileError>([&] { write_grey(directory.file("a.png"), wide.view()); }),
              "cannot write '" + directory.file("a.png") +
                  "': PNG has sides of at most 10^6 pixels; .tif and .pgm have no such limit");
    for (const char* name : {"a.tif", "a.pgm"}) {
      write_grey(directory.file(name), wide.view());
      EXPECT_EQ(read_grey(directory.file(name)).width(), 1'000'500);
    }
  }

  }  // namespace
}  // namespace thinbench
