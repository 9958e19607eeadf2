#include "support/whole_file.hpp"

#include <csignal>
#include <cstdlib>
#include <optional>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/file_size_limit.hpp"
#include "support/own_directory.hpp"
#include "support/rejection.hpp"
#include "support/unfinished_file.hpp"

namespace thinbench {
namespace {

std::string failure_of(const std::string& path, const std::string& bytes = "new") {
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
  EXPECT_EQ(failure_of("absent/a.json"),
            "cannot write 'absent/a.json': there is no directory 'absent'");
  EXPECT_EQ(failure_of("."), "cannot write '.': it is a directory");
  EXPECT_EQ(failure_of(""), "cannot write '': its name is empty");
}

TEST_F(WholeFile, failed_write_keeps_the_old_file_and_leaves_no_other) {
  put("a.json", "old");
  {
    const FileSizeLimit limit(100);
    EXPECT_EQ(failure_of("a.json", std::string(1000, 'x')),
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
  EXPECT_EQ(failure_of("pipe"), "cannot write 'pipe': it is not a regular file");
  EXPECT_TRUE(fs::is_fifo("pipe"));
  EXPECT_THROW(check_target("/dev/null"), FileError);
  fs::create_symlink("loop", "loop");
  EXPECT_EQ(failure_of("loop"), "cannot write 'loop': Too many levels of symbolic links");
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
    std::exit(failure_of("a.json", std::string(1000, 'x')).empty() ? 1 : 0);
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
