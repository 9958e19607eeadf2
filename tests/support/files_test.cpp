// Files that are read, locked and written whole.
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/file_bytes.hpp"
#include "support/file_error.hpp"
#include "support/file_size_limit.hpp"
#include "support/locked_file.hpp"
#include "support/own_directory.hpp"
#include "support/rejection.hpp"
#include "support/text.hpp"
#include "support/unfinished_file.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

using FileBytesTest = OwnDirectory;

std::string read_error_of(const std::string& path) {
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
  EXPECT_EQ(read_error_of("pipe"), "cannot read 'pipe': it is not a regular file");
  EXPECT_EQ(read_error_of("/dev/zero"), "cannot read '/dev/zero': it is not a regular file");
  EXPECT_EQ(read_error_of("."), "cannot read '.': it is a directory");
  EXPECT_EQ(read_error_of("none"), "cannot read 'none': there is no such file");
}

TEST_F(FileBytesTest, beyond_a_limit_is_rejected_before_it_is_read) {
  put("a", "");
  fs::resize_file("a", std::uintmax_t{1} << 40);
  EXPECT_EQ(read_error_of("a"), "cannot read 'a': it has more than 5 bytes");
  EXPECT_EQ(rejection_of<FileError>([&] { static_cast<void>(read_file("a", 1'000'000)); }),
            "cannot read 'a': it has more than 1,000,000 bytes");
}

TEST(ExtensionOf, is_in_lower_case_whatever_the_name_has) {
  EXPECT_EQ(extension_of("page.tif"), ".tif");
  EXPECT_EQ(extension_of("SCANS.D/PAGE.TIFF"), ".tiff");
  EXPECT_EQ(extension_of("a.b.Pbm"), ".pbm");
  EXPECT_EQ(extension_of("scans.d/page"), "");
}

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

std::string write_error_of(const std::string& path, const std::string& bytes = "new") {
  return rejection_of<FileError>([&] { write_whole_file(path, bytes); });
}

using WholeFile = OwnDirectory;

TEST_F(WholeFile, holds_all_bytes_and_leaves_no_temporary_file) {
  const std::string bytes("a\0b\n", 4);
  write_whole_file("a.json", bytes);
  EXPECT_EQ(bytes_of("a.json"), bytes);
  EXPECT_EQ(names(), Names{"a.json"});
}

TEST_F(WholeFile, replaces_an_existing_file_but_not_a_file_named_part) {
  put("a.json", "old");
  put("a.json.part", "unrelated");
  write_whole_file("a.json", "new");
  EXPECT_EQ(bytes_of("a.json"), "new");
  EXPECT_EQ(bytes_of("a.json.part"), "unrelated");
}

TEST_F(WholeFile, explains_why_a_path_cannot_be_written) {
  EXPECT_EQ(write_error_of("absent/a.json"),
            "cannot write 'absent/a.json': there is no directory 'absent'");
  EXPECT_EQ(write_error_of("."), "cannot write '.': it is a directory");
  EXPECT_EQ(write_error_of(""), "cannot write '': its name is empty");
}

TEST_F(WholeFile, failed_write_keeps_the_old_file_and_leaves_no_other) {
  put("a.json", "old");
  {
    const FileSizeLimit limit(100);
    EXPECT_EQ(write_error_of("a.json", std::string(1000, 'x')),
              "cannot write 'a.json': File too large");
  }
  EXPECT_EQ(bytes_of("a.json"), "old");
  EXPECT_EQ(names(), Names{"a.json"});
}

TEST_F(WholeFile, is_written_through_symbolic_links_even_to_a_file_that_does_not_exist_yet) {
  fs::create_directory("b");
  fs::create_symlink("link", "first");
  fs::create_symlink("b/a.json", "link");
  for (const char* bytes : {"new", "newer"}) {
    write_whole_file("first", bytes);
    EXPECT_EQ(bytes_of("b/a.json"), bytes);
  }
  EXPECT_TRUE(fs::is_symlink("link"));
  EXPECT_EQ(names(), (Names{"b", "first", "link"}));
}

TEST_F(WholeFile, replaces_nothing_but_regular_files) {
  ASSERT_EQ(mkfifo("pipe", 0666), 0);
  EXPECT_EQ(write_error_of("pipe"), "cannot write 'pipe': it is not a regular file");
  EXPECT_TRUE(fs::is_fifo("pipe"));
  EXPECT_THROW(check_target("/dev/null"), FileError);
  fs::create_symlink("loop", "loop");
  EXPECT_EQ(write_error_of("loop"), "cannot write 'loop': Too many levels of symbolic links");
}

TEST_F(WholeFile, replaced_file_keeps_its_mode) {
  put("a.json", "old");
  for (const mode_t mode : {0600U, 0666U, 0750U}) {
    ASSERT_EQ(chmod("a.json", mode), 0);
    write_whole_file("a.json", [&](const std::string& name) {
      struct stat facts {};
      ASSERT_EQ(stat(name.c_str(), &facts), 0);
      EXPECT_EQ(facts.st_mode & 0777 & ~mode, 0U) << "the hidden file is more open";
      std::ofstream(name) << "new";
    });
    struct stat facts {};
    ASSERT_EQ(stat("a.json", &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777, mode);
  }
}

TEST_F(WholeFile, replaced_file_keeps_its_other_names) {
  put("a.json", "old, and longer");
  fs::create_hard_link("a.json", "b.json");
  for (const char* bytes : {"new", ""}) {
    write_whole_file("a.json", bytes);
    EXPECT_EQ(bytes_of("b.json"), bytes);
    EXPECT_EQ(fs::hard_link_count("a.json"), 2U);
  }
  EXPECT_EQ(names(), (Names{"a.json", "b.json"}));
}

/// Writes so many bytes; then no file may grow beyond the limit.
void write_then_limit(const std::string& path, std::size_t bytes, rlim_t limit) {
  std::optional<FileSizeLimit> full;
  write_whole_file(path, [&](const std::string& name) {
    std::ofstream(name) << std::string(bytes, 'x');
    full.emplace(limit);
  });
}

TEST_F(WholeFile, full_disk_keeps_an_old_file_of_two_names) {
  put("a.json", "old");
  fs::create_hard_link("a.json", "b.json");
  EXPECT_EQ(rejection_of<FileError>([&] { write_then_limit("a.json", 100'000, 20'000); }),
            "cannot write 'a.json': File too large");
  EXPECT_EQ(bytes_of("b.json"), "old");
  EXPECT_EQ(names(), (Names{"a.json", "b.json"}));
}

TEST_F(WholeFile, kill_while_a_file_of_two_names_is_overwritten_leaves_all_bytes_of_one) {
  put("a.json", std::string(50'000, 'o'));
  fs::create_hard_link("a.json", "b.json");
  const auto write_and_die = [&] {
    write_whole_file("a.json", [&](const std::string& name) {
      std::ofstream(name) << std::string(100'000, 'x');
      static const FileSizeLimit full(20'000);
      std::signal(SIGXFSZ, SIG_DFL);
    });
  };
  EXPECT_EXIT(write_and_die(), testing::KilledBySignal(SIGXFSZ), "");
  EXPECT_EQ(bytes_of("a.json"), std::string(50'000, 'o'));
}

TEST_F(WholeFile, owner_of_a_replaced_file_remains) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can give files to others";
  put("a.json", "old");
  ASSERT_EQ(chown("a.json", 1234, 5678), 0);
  write_whole_file("a.json", "new");
  struct stat facts {};
  ASSERT_EQ(stat("a.json", &facts), 0);
  EXPECT_EQ(facts.st_uid, 1234U);
  EXPECT_EQ(facts.st_gid, 5678U);
}

TEST_F(WholeFile, signals_that_end_the_program_leave_the_old_file_and_no_other) {
  put("a.json", "old");
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const auto write_and_die = [&] {
      std::signal(number, SIG_DFL);  // nohup may have left it ignored
      remove_unfinished_files_on_signals();
      write_whole_file("a.json", [&](const std::string& name) {
        std::ofstream(name) << "new";
        std::raise(number);
      });
    };
    EXPECT_EXIT(write_and_die(), testing::KilledBySignal(number), "");
    EXPECT_EQ(bytes_of("a.json"), "old");
    EXPECT_EQ(names(), Names{"a.json"});
  }
}

TEST_F(WholeFile, limit_of_file_sizes_is_an_error_and_not_the_end_of_the_program) {
  put("a.json", "old");
  const auto write_too_much = [&] {
    const FileSizeLimit limit(100);
    std::signal(SIGXFSZ, SIG_DFL);
    remove_unfinished_files_on_signals();
    std::exit(write_error_of("a.json", std::string(1000, 'x')).empty() ? 1 : 0);
  };
  EXPECT_EXIT(write_too_much(), testing::ExitedWithCode(0), "");
  EXPECT_EQ(names(), Names{"a.json"});
}

TEST_F(WholeFile, signal_that_was_ignored_still_is) {
  const auto hang_up = [] {
    std::signal(SIGHUP, SIG_IGN);  // as nohup does
    remove_unfinished_files_on_signals();
    std::raise(SIGHUP);
    std::exit(0);
  };
  EXPECT_EXIT(hang_up(), testing::ExitedWithCode(0), "");
}

TEST_F(WholeFile, abandoned_files_are_removed_but_not_those_being_written) {
  put(".thinbench-1", "part");
  put("a.json", "whole");
  write_whole_file("b.json", [&](const std::string& name) {
    remove_abandoned_files(".");
    std::ofstream(name) << "new";
  });
  EXPECT_EQ(names(), (Names{"a.json", "b.json"}));
}

}  // namespace
}  // namespace thinbench
