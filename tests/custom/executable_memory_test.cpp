// Machine code where the system denies executable memory.
#include <cerrno>
#include <cstddef>
#include <cstdlib>

#include <gtest/gtest.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include "custom/machine_code.hpp"
#include "image/byte_image.hpp"
#include "reference.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench::detail {
namespace {

/// From now on this process cannot make memory executable.
bool deny_executable_memory() {
  constexpr unsigned kProtection = offsetof(seccomp_data, args[2]);
  sock_filter instructions[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_mprotect, 0, 3),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kProtection),
      BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, PROT_EXEC, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EACCES),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog program = {std::size(instructions), instructions};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

/// Exit status 0 if the rule runs and is right, 1 if not, 2 if nothing could be denied.
[[noreturn]] void apply_without_executable_memory() {
  if (!deny_executable_memory()) std::exit(2);
  if (MachineCode::is_available(Isa::avx2)) std::exit(1);
  const WindowTable life = table_from_hensel("B3/S23");
  ByteImage image(100, 40);
  for (Index x = 0; x < 100; ++x) image.at(x, x * 7 % 40) = image.at(x, 20) = 255;
  ByteImage want(100, 40);
  const int iterations =
      reference::apply_tables({&life, 1}, {Border::background, 30}, image.view(), want.view());
  const CustomRule rule(life, {.max_iterations = 30});
  const bool right = apply(rule, image.view(), image.view()) == iterations;
  std::exit(right && equal(image.view(), want.view()) ? 0 : 1);
}

TEST(MachineCodeDeathTest, interpreter_runs_rules_where_memory_cannot_be_executable) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto in_child = [] { apply_without_executable_memory(); };
  const auto denied_or_unsupported = [](int status) {
    return WIFEXITED(status) && WEXITSTATUS(status) != 1;
  };
  EXPECT_EXIT(in_child(), denied_or_unsupported, "");
}

}  // namespace
}  // namespace thinbench::detail
