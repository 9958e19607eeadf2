// Machine code where the system denies executable memory.
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "compile/machine_code.hpp"
#include "core/byte_image.hpp"
#include "reference.hpp"
#include "thinbench/rule_notation.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench::detail {
namespace {

/// From now on this process cannot ask for memory with all of `protection`.
bool deny_memory(unsigned protection) {
  sock_filter instructions[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_mmap, 1, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_mprotect, 0, 4),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args[2])),
      BPF_STMT(BPF_ALU | BPF_AND | BPF_K, protection),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, protection, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EACCES),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog program = {std::size(instructions), instructions};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

constexpr int kRight = 0;
constexpr int kWrong = 1;
constexpr int kNotDenied = 2;

bool is_right(const Rule& rule, int limit) {
  ByteImage image(700, 40);  // wider than the row kernel
  for (Index x = 0; x < image.width(); ++x) {
    for (Index y = 10 + x % 7; y < 30; ++y) image.at(x, y) = 255;
  }
  ByteImage want(image.width(), image.height());
  const int iterations = reference::apply_tables(rule.sub_iterations(), {Border::background, limit},
                                                 image.view(), want.view());
  return thin(rule, image.view(), image.view()) == iterations && equal(image.view(), want.view());
}

/// Life, and a rule for which tiles are chosen.
bool rules_are_right(int limit) {
  const WindowTable erode = make_window_table([](std::size_t window) { return window == 511; });
  return is_right(Rule(table_from_hensel("B3/S23"), {.max_iterations = limit}), limit) &&
         is_right(Rule(erode, {.max_iterations = limit}), limit);
}

[[noreturn]] void apply_without_executable_memory(bool after_use) {
  if (after_use && !MachineCode::is_available(Isa::avx2)) std::exit(kNotDenied);
  if (!deny_memory(PROT_EXEC)) std::exit(kNotDenied);
  std::exit(rules_are_right(5) ? kRight : kWrong);
}

/// Runs `body` in a process of its own and returns its exit status.
template <class Body>
int status_of(const Body& body) {
  const pid_t child = fork();
  if (child == 0) body();
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : kWrong;
}

/// How much memory this process can execute.
std::size_t executable_bytes() {
  std::ifstream mappings("/proc/self/maps");
  std::size_t bytes = 0;
  for (std::string line; std::getline(mappings, line);) {
    std::size_t begin = 0, end = 0;
    char dash = 0, read = 0, write = 0, execute = 0;
    std::istringstream(line) >> std::hex >> begin >> dash >> end >> read >> write >> execute;
    if (execute == 'x') bytes += end - begin;
  }
  return bytes;
}

bool makes_code() {
  const GateNetwork identity = {.gates = {}, .output = WindowTable::kCentre};
  return MachineCode::make(identity, Isa::avx2, Layout::words, false) != nullptr;
}

TEST(MachineCode, gives_its_memory_back) {
  if (!MachineCode::is_available(Isa::avx2)) GTEST_SKIP() << "no machine code here";
  ASSERT_TRUE(makes_code());
  const std::size_t before = executable_bytes();
  ASSERT_GT(before, 0U);
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(makes_code());
  EXPECT_EQ(executable_bytes(), before);
}

TEST(MachineCode, needs_no_memory_that_is_writable_and_executable) {
  if (!MachineCode::is_available(Isa::avx2)) GTEST_SKIP() << "no machine code here";
  const int status = status_of([] {
    if (!deny_memory(PROT_WRITE | PROT_EXEC)) std::exit(kNotDenied);
    std::exit(makes_code() ? kRight : kWrong);
  });
  if (status == kNotDenied) GTEST_SKIP() << "this system does not let a process deny it";
  EXPECT_EQ(status, kRight);
}

TEST(MachineCode, interpreter_runs_rules_where_memory_cannot_be_executable) {
  const int status = status_of([] { apply_without_executable_memory(false); });
  if (status == kNotDenied) GTEST_SKIP() << "this system does not let a process deny it";
  EXPECT_EQ(status, kRight);
}

TEST(MachineCode, other_engines_run_rules_where_memory_is_denied_later) {
  const int status = status_of([] { apply_without_executable_memory(true); });
  if (status == kNotDenied) GTEST_SKIP() << "no machine code here, or nothing denies it";
  EXPECT_EQ(status, kRight);
}

}  // namespace
}  // namespace thinbench::detail
