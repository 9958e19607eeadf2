// Runs that are killed and resumed.
#include <climits>
#include <csignal>
#include <fstream>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "harness/test_images.hpp"
#include "out_of_core/checkpoint.hpp"
#include "out_of_core/packed_files.hpp"
#include "support/rejection.hpp"
#include "support/unfinished_file.hpp"

namespace thinbench {
namespace {

using Names = std::set<std::string>;

/// A run of several passes.
PreparedRun thick_strokes(const Rule& rule = Rule::guo_hall) {
  const PackedImage source(noise_image(260, 130, 75, 24, 3).view(), BitOrder::msb_first);
  return {source, {.rule = rule, .tiling = small_tiles(rule, source.view(), 3)}};
}

struct Expected {
  std::string bytes;
  int iterations;
  int passes;
};

Expected undisturbed() {
  const PreparedRun prepared = thick_strokes();
  const OutOfCoreResult result = thin_out_of_core(prepared.run);
  return {prepared.result(), result.iterations, result.passes};
}

/// Runs in another process, which dies by SIGKILL before its tile number `tiles`. False if the run
/// ended before.
bool run_and_kill(OutOfCoreRun run, int tiles) {
  const pid_t child = fork();
  if (child == 0) {
    run.on_tile = [&](int, Index) {
      if (tiles-- == 0) kill(getpid(), SIGKILL);
    };
    thin_out_of_core(run);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  const bool killed = WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
  if (!killed && status != 0) throw std::runtime_error("the run died of something else");
  return killed;
}

TEST(Resume, gives_the_same_result_after_a_kill_at_every_seventh_tile) {
  const Expected expected = undisturbed();
  ASSERT_GT(expected.passes, 2);
  constexpr int kStep = 7;
  int kills = 0;
  for (int tiles = 0;; tiles += kStep) {
    PreparedRun prepared = thick_strokes();
    if (!run_and_kill(prepared.run, tiles)) break;
    ++kills;
    EXPECT_FALSE(prepared.directory.names().contains("out"));
    prepared.run.resume = true;
    const OutOfCoreResult result = thin_out_of_core(prepared.run);
    EXPECT_TRUE(prepared.result() == expected.bytes) << "killed at tile " << tiles;
    EXPECT_EQ(result.iterations, expected.iterations);
    EXPECT_EQ(prepared.directory.names(), (Names{"in", "out"}));
  }
  EXPECT_EQ(kills, (expected.passes * 25 + kStep - 1) / kStep);
}

TEST(Resume, continues_at_the_interrupted_pass_even_if_killed_again_and_again) {
  const Expected expected = undisturbed();
  PreparedRun prepared = thick_strokes();
  prepared.run.resume = true;
  int kills = 0;
  // One pass and a part of the next; a run that never ends would be killed for ever.
  while (kills < expected.passes && run_and_kill(prepared.run, 30)) ++kills;
  EXPECT_EQ(kills, expected.passes - 1);
  EXPECT_TRUE(prepared.result() == expected.bytes);
}

TEST(Resume, without_it_a_run_begins_again) {
  PreparedRun prepared = thick_strokes();
  ASSERT_TRUE(run_and_kill(prepared.run, 40));
  int first_pass = -1;
  prepared.run.on_tile = [&](int pass, Index) { first_pass = first_pass < 0 ? pass : first_pass; };
  thin_out_of_core(prepared.run);
  EXPECT_EQ(first_pass, 0);
  EXPECT_TRUE(prepared.result() == undisturbed().bytes);
}

/// Ends a run by SIGTERM in this pass, as Ctrl-C does by SIGINT.
void run_and_end(OutOfCoreRun run, int in_pass) {
  remove_unfinished_files_on_signals();
  run.on_tile = [in_pass](int pass, Index) {
    if (pass == in_pass) std::raise(SIGTERM);
  };
  thin_out_of_core(run);
}

TEST(Resume, run_ended_in_its_first_pass_leaves_nothing_and_later_what_resume_needs) {
  PreparedRun prepared = thick_strokes();
  EXPECT_EXIT(run_and_end(prepared.run, 0), testing::KilledBySignal(SIGTERM), "");
  EXPECT_EQ(prepared.directory.names(), Names{"in"});
  EXPECT_EXIT(run_and_end(prepared.run, 1), testing::KilledBySignal(SIGTERM), "");
  EXPECT_EQ(prepared.directory.names(),
            (Names{"in", ".out.thinbench-a", ".out.thinbench-b", ".out.thinbench-state"}));
  prepared.run.resume = true;
  thin_out_of_core(prepared.run);
  EXPECT_TRUE(prepared.result() == undisturbed().bytes);
  EXPECT_EQ(prepared.directory.names(), (Names{"in", "out"}));
}

TEST(Resume, output_is_written_through_a_symbolic_link_and_keeps_mode_and_other_names) {
  const Expected expected = undisturbed();
  PreparedRun prepared = thick_strokes();
  const std::string target = prepared.directory.with("target/image", "old");
  ASSERT_EQ(chmod(target.c_str(), 0600), 0);
  std::filesystem::create_symlink("target/image", prepared.run.out);
  thin_out_of_core(prepared.run);
  EXPECT_TRUE(bytes_of(target) == expected.bytes);
  EXPECT_EQ(std::filesystem::status(target).permissions(), std::filesystem::perms{0600});
  std::filesystem::create_hard_link(target, prepared.directory.file("other"));
  ASSERT_TRUE(prepared.directory.with("target/image", "old") == target);
  thin_out_of_core(prepared.run);
  EXPECT_TRUE(bytes_of(prepared.directory.file("other")) == expected.bytes);
  EXPECT_TRUE(std::filesystem::is_symlink(prepared.run.out));
  EXPECT_EQ(prepared.directory.names(), (Names{"in", "out", "other", "target"}));
}

Rule as_tables(const Rule& rule) {
  return Rule(rule.sub_iterations());
}

void expect_another_run(OutOfCoreRun run) {
  run.resume = true;
  const std::string error = rejection_of<FileError>([&] { thin_out_of_core(run); });
  EXPECT_NE(error.find("it belongs to another run"), std::string::npos) << error;
  EXPECT_TRUE(is_one_sentence(error)) << error;
}

TEST(Resume, run_with_other_options_or_tables_is_rejected_and_keeps_the_files) {
  PreparedRun prepared = thick_strokes(as_tables(Rule::guo_hall));
  ASSERT_TRUE(run_and_kill(prepared.run, 40));
  const Names names = prepared.directory.names();
  OutOfCoreRun other_options = prepared.run;
  other_options.thinning.border = Border::keep;
  OutOfCoreRun other_tables = prepared.run;
  other_tables.rule = as_tables(Rule::zhang_suen);
  OutOfCoreRun other_order = prepared.run;
  other_order.format.order = BitOrder::lsb_first;
  for (const OutOfCoreRun& other : {other_options, other_tables, other_order}) {
    expect_another_run(other);
    EXPECT_EQ(prepared.directory.names(), names);
  }
  prepared.run.resume = true;
  prepared.run.rule = as_tables(Rule::guo_hall);
  thin_out_of_core(prepared.run);
  EXPECT_TRUE(prepared.result() == undisturbed().bytes);
}

/// Runs in another process, which dies when a file of it grows beyond `bytes`.
bool run_and_kill_beyond(const OutOfCoreRun& run, rlim_t bytes) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, SIG_DFL);
    thin_out_of_core(run);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGXFSZ;
}

TEST(Resume, kill_while_the_state_is_written_leaves_nothing_that_the_next_run_does_not_remove) {
  const PackedImage source(noise_image(200, 10, 90, 8, 3).view(), BitOrder::msb_first);
  OutOfCoreRun run{.rule = Rule::naccache_shinghal};
  run.tiling = small_tiles(run.rule, source.view(), 1, 8, 1);  // more state than pixels
  for (const bool resumes : {false, true}) {
    PreparedRun prepared(source, run);
    ASSERT_TRUE(run_and_kill_beyond(prepared.run, 300));
    EXPECT_EQ(prepared.directory.names().size(), 3U);  // a work file and a part of the state
    prepared.run.resume = resumes;
    thin_out_of_core(prepared.run);
    EXPECT_EQ(prepared.directory.names(), (Names{"in", "out"}));
  }
}

/// IN holds one byte and the pixels; OUT is to hold another byte and the pixels.
Conversion behind_a_byte(const OutOfCoreRun& run) {
  const auto pixels = [run](std::vector<std::uint8_t>& bytes) {
    bytes.resize(static_cast<std::size_t>(run.format.file_bytes()));
    return Block{0, 0, run.format.width, run.format.height};
  };
  Conversion conversion;
  conversion.unpack = [run, pixels](const PackedFile& to) {
    std::vector<std::uint8_t> bytes;
    const Block all = pixels(bytes);
    const std::string text = bytes_of(run.in);
    std::copy(text.begin() + 1, text.end(), bytes.begin());
    to.write(all, bytes.data(), all.row_bytes());
  };
  conversion.pack = [pixels](const PackedFile& from, const std::string& name) {
    std::vector<std::uint8_t> bytes;
    const Block all = pixels(bytes);
    from.read(all, bytes.data());
    std::ofstream(name, std::ios::binary) << 'o' << std::string(bytes.begin(), bytes.end());
  };
  conversion.name = ", behind a byte";
  return conversion;
}

TEST(Resume, converted_files_are_unpacked_once_and_resumed_like_others) {
  const Expected expected = undisturbed();
  int kills = 0;
  for (int tiles = 3;; tiles += 17) {
    PreparedRun prepared = thick_strokes();
    static_cast<void>(prepared.directory.with("in", 'i' + bytes_of(prepared.run.in)));
    prepared.run.conversion = behind_a_byte(prepared.run);
    if (!run_and_kill(prepared.run, tiles)) break;
    ++kills;
    prepared.run.resume = true;
    OutOfCoreRun other = prepared.run;
    other.conversion.name = ", otherwise";
    if (tiles > 25) {
      expect_another_run(other);
      prepared.run.conversion.unpack = [](const PackedFile&) { ADD_FAILURE() << "unpacked again"; };
    }
    EXPECT_EQ(thin_out_of_core(prepared.run).iterations, expected.iterations);
    EXPECT_TRUE(prepared.result() == 'o' + expected.bytes) << "killed at tile " << tiles;
    EXPECT_EQ(prepared.directory.names(), (Names{"in", "out"}));
  }
  EXPECT_GT(kills, 3);
}

constexpr const char* kDamaged = "': the file is damaged; run without --resume to begin again";

TEST(Resume, damaged_state_is_reported) {
  PreparedRun prepared = thick_strokes();
  ASSERT_TRUE(run_and_kill(prepared.run, 40));
  const std::string state = prepared.directory.file(".out.thinbench-state");
  const std::string bytes = bytes_of(state);
  prepared.run.resume = true;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    static_cast<void>(prepared.directory.with(".out.thinbench-state", damaged));
    EXPECT_EQ(rejection_of<FileError>([&] { thin_out_of_core(prepared.run); }),
              "cannot resume from '" + state + kDamaged)
        << damaged;
  }
  static_cast<void>(prepared.directory.with(".out.thinbench-state", bytes));
  thin_out_of_core(prepared.run);
  EXPECT_TRUE(prepared.result() == undisturbed().bytes);
}

TEST(Resume, values_that_no_run_writes_are_damage_even_with_their_checksum) {
  const TemporaryDirectory directory;
  const std::string state = directory.file("state");
  const CheckpointLimits limits{2, 100, 5};
  const Checkpoint good{5, 100, 9, {true, false}, "0"};
  const auto saved_and_loaded = [&](const auto& change) {
    Checkpoint checkpoint = good;
    change(checkpoint);
    save_checkpoint(state, "run", checkpoint);
    return rejection_of<FileError>(
        [&] { static_cast<void>(load_checkpoint(state, "run", limits)); });
  };
  EXPECT_EQ(saved_and_loaded([](Checkpoint&) {}), "");
  const std::string damaged = "cannot resume from '" + state + kDamaged;
  for (const int passes : {-1, 0, 6, INT_MAX}) {
    EXPECT_EQ(saved_and_loaded([&](Checkpoint& one) { one.passes = passes; }), damaged) << passes;
  }
  for (const Index pixels : {Index{-1}, Index{101}, INT64_MAX}) {
    EXPECT_EQ(saved_and_loaded([&](Checkpoint& one) { one.foreground_before = pixels; }), damaged);
    EXPECT_EQ(saved_and_loaded([&](Checkpoint& one) { one.foreground_after = pixels; }), damaged);
  }
  for (const std::size_t tiles : {0U, 1U, 3U}) {
    EXPECT_EQ(saved_and_loaded([&](Checkpoint& one) { one.unsettled.resize(tiles); }), damaged);
  }
}

void flip_a_bit(const std::string& file) {
  std::string bytes = bytes_of(file);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
  std::ofstream(file, std::ios::binary) << bytes;
}

TEST(Resume, work_file_that_is_needed_is_checked_and_the_other_is_not_needed) {
  const Expected expected = undisturbed();
  PreparedRun prepared = thick_strokes();
  ASSERT_TRUE(run_and_kill(prepared.run, 60));  // in the third pass: from b to a
  prepared.run.resume = true;
  const std::string needed = prepared.directory.file(".out.thinbench-b");
  flip_a_bit(needed);
  EXPECT_EQ(rejection_of<FileError>([&] { thin_out_of_core(prepared.run); }),
            "cannot read '" + needed +
                "': its pixels are not those that the interrupted run wrote; run without --resume "
                "to begin again");
  flip_a_bit(needed);
  flip_a_bit(prepared.directory.file(".out.thinbench-a"));
  EXPECT_EQ(thin_out_of_core(prepared.run).iterations, expected.iterations);
  EXPECT_TRUE(prepared.result() == expected.bytes);
}

TEST(Resume, another_input_of_the_same_size_and_time_is_rejected) {
  PreparedRun prepared = thick_strokes();
  ASSERT_TRUE(run_and_kill(prepared.run, 40));
  prepared.run.resume = true;
  const auto time = std::filesystem::last_write_time(prepared.run.in);
  flip_a_bit(prepared.run.in);
  std::filesystem::last_write_time(prepared.run.in, time);
  expect_another_run(prepared.run);
  flip_a_bit(prepared.run.in);  // its time is another, but not its pixels
  thin_out_of_core(prepared.run);
  EXPECT_TRUE(prepared.result() == undisturbed().bytes);
}

}  // namespace
}  // namespace thinbench
