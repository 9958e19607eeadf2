#include "support/whole_file.hpp"

#include <csignal>
#include <cstdlib>
#include <optional>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/file_size_limit.hpp"
#include "support/rejection.hpp"
#include "support/temporary_directory.hpp"
#include "support/unfinished_file.hpp"

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

TEST(WholeFile, is_written_through_symbolic_links_even_to_a_file_that_does_not_exist_yet) {
  const TemporaryDirectory directory;
  std::filesystem::create_directory(directory.file("b"));
  std::filesystem::create_symlink("link", directory.file("first"));
  std::filesystem::create_symlink("b/a.json", directory.file("link"));
  for (const char* bytes : {"new", "newer"}) {
    write_whole_file(directory.file("first"), bytes);
    EXPECT_EQ(bytes_of(directory.file("b/a.json")), bytes);
  }
  EXPECT_TRUE(std::filesystem::is_symlink(directory.file("link")));
  EXPECT_EQ(directory.names(), (Names{"b", "first", "link"}));
}

TEST(WholeFile, replaces_nothing_but_regular_files) {
  const TemporaryDirectory directory;
  const std::string pipe = directory.file("a.json");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0666), 0);
  EXPECT_EQ(failure_of(pipe), "cannot write '" + pipe + "': it is not a regular file");
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  EXPECT_THROW(check_target("/dev/null"), FileError);
  const std::string loop = directory.file("loop");
  std::filesystem::create_symlink("loop", loop);
  EXPECT_EQ(failure_of(loop), "cannot write '" + loop + "': Too many levels of symbolic links");
}

TEST(WholeFile, replaced_file_keeps_its_mode) {
  const TemporaryDirectory directory;
  const std::string file = directory.with("a.json", "old");
  for (const mode_t mode : {0600U, 0666U, 0750U}) {
    ASSERT_EQ(chmod(file.c_str(), mode), 0);
    write_whole_file(file, [&](const std::string& name) {
      struct stat facts {};
      ASSERT_EQ(stat(name.c_str(), &facts), 0);
      EXPECT_EQ(facts.st_mode & 0777 & ~mode, 0U) << "the hidden file is more open";
      std::ofstream(name) << "new";
    });
    struct stat facts {};
    ASSERT_EQ(stat(file.c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777, mode);
  }
}

TEST(WholeFile, replaced_file_keeps_its_other_names) {
  const TemporaryDirectory directory;
  const std::string file = directory.with("a.json", "old, and longer");
  std::filesystem::create_hard_link(file, directory.file("b.json"));
  for (const char* bytes : {"new", ""}) {
    write_whole_file(file, bytes);
    EXPECT_EQ(bytes_of(directory.file("b.json")), bytes);
    EXPECT_EQ(std::filesystem::hard_link_count(file), 2U);
  }
  EXPECT_EQ(directory.names(), (Names{"a.json", "b.json"}));
}

/// Writes so many bytes; then no file may grow beyond the limit.
void write_then_limit(const std::string& path, std::size_t bytes, rlim_t limit) {
  std::optional<FileSizeLimit> full;
  write_whole_file(path, [&](const std::string& name) {
    std::ofstream(name) << std::string(bytes, 'x');
    full.emplace(limit);
  });
}

TEST(WholeFile, full_disk_keeps_an_old_file_of_two_names) {
  const TemporaryDirectory directory;
  const std::string file = directory.with("a.json", "old");
  std::filesystem::create_hard_link(file, directory.file("b.json"));
  EXPECT_EQ(rejection_of<FileError>([&] { write_then_limit(file, 100'000, 20'000); }),
            "cannot write '" + file + "': File too large");
  EXPECT_EQ(bytes_of(directory.file("b.json")), "old");
  EXPECT_EQ(directory.names(), (Names{"a.json", "b.json"}));
}

TEST(WholeFile, kill_while_a_file_of_two_names_is_overwritten_leaves_all_bytes_of_one) {
  const TemporaryDirectory directory;
  const std::string file = directory.with("a.json", std::string(50'000, 'o'));
  std::filesystem::create_hard_link(file, directory.file("b.json"));
  const auto write_and_die = [&] {
    write_whole_file(file, [&](const std::string& name) {
      std::ofstream(name) << std::string(100'000, 'x');
      static const FileSizeLimit full(20'000);
      std::signal(SIGXFSZ, SIG_DFL);
    });
  };
  EXPECT_EXIT(write_and_die(), testing::KilledBySignal(SIGXFSZ), "");
  EXPECT_EQ(bytes_of(file), std::string(50'000, 'o'));
}

TEST(WholeFile, owner_of_a_replaced_file_remains) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can give files to others";
  const TemporaryDirectory directory;
  const std::string file = directory.with("a.json", "old");
  ASSERT_EQ(chown(file.c_str(), 1234, 5678), 0);
  write_whole_file(file, "new");
  struct stat facts {};
  ASSERT_EQ(stat(file.c_str(), &facts), 0);
  EXPECT_EQ(facts.st_uid, 1234U);
  EXPECT_EQ(facts.st_gid, 5678U);
}

TEST(WholeFile, signals_that_end_the_program_leave_the_old_file_and_no_other) {
  const TemporaryDirectory directory;
  const std::string file = directory.with("a.json", "old");
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const auto write_and_die = [&] {
      remove_unfinished_files_on_signals();
      write_whole_file(file, [&](const std::string& name) {
        std::ofstream(name) << "new";
        std::raise(number);
      });
    };
    EXPECT_EXIT(write_and_die(), testing::KilledBySignal(number), "");
    EXPECT_EQ(bytes_of(file), "old");
    EXPECT_EQ(directory.names(), Names{"a.json"});
  }
}

TEST(WholeFile, limit_of_file_sizes_is_an_error_and_not_the_end_of_the_program) {
  const TemporaryDirectory directory;
  const std::string file = directory.with("a.json", "old");
  const auto write_too_much = [&] {
    const FileSizeLimit limit(100);
    std::signal(SIGXFSZ, SIG_DFL);
    remove_unfinished_files_on_signals();
    std::exit(failure_of(file, std::string(1000, 'x')) == "written" ? 1 : 0);
  };
  EXPECT_EXIT(write_too_much(), testing::ExitedWithCode(0), "");
  EXPECT_EQ(directory.names(), Names{"a.json"});
}

TEST(WholeFile, signal_that_was_ignored_still_is) {
  const auto hang_up = [] {
    std::signal(SIGHUP, SIG_IGN);  // as nohup does
    remove_unfinished_files_on_signals();
    std::raise(SIGHUP);
    std::exit(0);
  };
  EXPECT_EXIT(hang_up(), testing::ExitedWithCode(0), "");
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
