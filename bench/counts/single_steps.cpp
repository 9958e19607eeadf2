#include "counts/single_steps.hpp"

#if defined(__x86_64__)
#include <atomic>
#include <csignal>
#include <system_error>

#include <ucontext.h>
#include <x86intrin.h>

namespace thinbench {
namespace {

constexpr unsigned long long kTrapFlag = 0x100;

/// What the handler of the traps keeps: it gets no argument of ours.
struct Walk {
  std::uint64_t most = 0;
  std::uint64_t taken = 0;
  std::uint64_t instructions = 0;
  std::uint64_t latest = 0;  // address of an instruction
};

Walk walk;

/// A trap comes before an instruction. Where that is the same as before, it repeats itself.
void on_trap(int, siginfo_t*, void* context) {
  auto& registers = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
  const auto next = static_cast<std::uint64_t>(registers[REG_RIP]);
  if (next != walk.latest) ++walk.instructions;
  walk.latest = next;
  if (++walk.taken > walk.most) registers[REG_EFL] &= ~static_cast<greg_t>(kTrapFlag);
}

class TrapHandler {
 public:
  TrapHandler() {
    struct sigaction action {};
    action.sa_sigaction = &on_trap;
    action.sa_flags = SA_SIGINFO;
    if (sigaction(SIGTRAP, &action, &before_) != 0) {
      throw std::system_error(errno, std::generic_category(), "no handler for traps");
    }
  }
  ~TrapHandler() { sigaction(SIGTRAP, &before_, nullptr); }
  TrapHandler(const TrapHandler&) = delete;
  TrapHandler& operator=(const TrapHandler&) = delete;

 private:
  struct sigaction before_ {};
};

/// The instructions of a call and of setting and clearing the flag around it.
[[gnu::noinline]] Walk walk_through(const std::function<void()>& call, std::uint64_t most) {
  walk = {.most = most};
  std::atomic_signal_fence(std::memory_order_seq_cst);
  __writeeflags(__readeflags() | kTrapFlag);
  call();
  __writeeflags(__readeflags() & ~kTrapFlag);
  std::atomic_signal_fence(std::memory_order_seq_cst);
  return walk;
}

}  // namespace

std::optional<std::uint64_t> instructions_of(const std::function<void()>& call,
                                             std::uint64_t max_steps) {
  constexpr std::uint64_t kMaxCallOverhead = 1000;
  const TrapHandler handler;
  const Walk empty = walk_through([] {}, kMaxCallOverhead);
  const Walk all = walk_through(call, max_steps + empty.taken);
  if (all.taken > all.most) return std::nullopt;
  return all.instructions - empty.instructions;
}

}  // namespace thinbench

#else

namespace thinbench {

std::optional<std::uint64_t> instructions_of(const std::function<void()>&, std::uint64_t) {
  return std::nullopt;
}

}  // namespace thinbench

#endif
