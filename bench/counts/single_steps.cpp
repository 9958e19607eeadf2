#include "counts/single_steps.hpp"

#if defined(__x86_64__)
#include <csignal>
#include <system_error>

#include <ucontext.h>
#include <x86intrin.h>

namespace thinbench {
namespace {

constexpr unsigned long long kTrapFlag = 0x100;

/// What the handler of the traps keeps: it gets no argument of ours.
struct Steps {
  std::uint64_t most = 0;
  std::uint64_t taken = 0;
  std::uint64_t instructions = 0;
  greg_t next = 0;  // the instruction that the latest trap stood before
};

Steps steps;

/// A trap comes before an instruction. Where that is the same as before, it repeats itself.
void on_trap(int, siginfo_t*, void* context) {
  auto& registers = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
  const greg_t next = registers[REG_RIP];
  if (next != steps.next) ++steps.instructions;
  steps.next = next;
  if (++steps.taken > steps.most) registers[REG_EFL] &= ~static_cast<greg_t>(kTrapFlag);
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
  TrapHandler(TrapHandler&&) = delete;
  TrapHandler& operator=(TrapHandler&&) = delete;

 private:
  struct sigaction before_ {};
};

/// The instructions of a call and of setting and clearing the flag round it.
[[gnu::noinline]] Steps steps_round(const std::function<void()>& call, std::uint64_t most) {
  steps = {.most = most};
  __writeeflags(__readeflags() | kTrapFlag);
  call();
  __writeeflags(__readeflags() & ~kTrapFlag);
  return steps;
}

}  // namespace

std::optional<std::uint64_t> instructions_of(const std::function<void()>& call,
                                             std::uint64_t max_steps) {
  const TrapHandler handler;
  const Steps none = steps_round([] {}, ~std::uint64_t{0});
  const Steps all = steps_round(call, max_steps + none.taken);
  if (all.taken > all.most) return std::nullopt;
  return all.instructions - none.instructions;
}

}  // namespace thinbench

#else

namespace thinbench {

std::optional<std::uint64_t> instructions_of(const std::function<void()>&, std::uint64_t) {
  return std::nullopt;
}

}  // namespace thinbench

#endif
