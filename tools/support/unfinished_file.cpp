#include "support/unfinished_file.hpp"

#include <array>
#include <atomic>
#include <csignal>
#include <utility>

#include <unistd.h>

namespace thinbench {
namespace {

/// More than there are threads. A file without a slot remains after a signal.
constexpr std::size_t kSlots = 2048;

// Read by the handler of signals, which may use nothing that a thread could have locked.
std::array<std::atomic<const char*>, kSlots> names;  // null: a free slot
std::atomic<bool> is_ending = false;

static_assert(std::atomic<const char*>::is_always_lock_free);

extern "C" void end_program(int number) {
  is_ending = true;
  for (std::atomic<const char*>& slot : names) {
    const char* name = slot.exchange(nullptr);
    if (name != nullptr) unlink(name);
  }
  std::raise(number);  // its action is the default again
}

/// For threads whose files the handler removes.
[[noreturn]] void wait_for_the_end() {
  while (true) pause();
}

std::size_t slot_with(const char* name) {
  for (std::size_t i = 0; i < kSlots; ++i) {
    const char* free = nullptr;
    if (names[i].compare_exchange_strong(free, name)) return i;
  }
  return kSlots;
}

}  // namespace

UnfinishedFile::UnfinishedFile(std::string name)
    : name_(std::move(name)), slot_(slot_with(name_.c_str())) {
  if (is_ending) wait_for_the_end();
}

UnfinishedFile::~UnfinishedFile() {
  leave_slot();
  if (!name_.empty()) unlink(name_.c_str());
}

void UnfinishedFile::keep() {
  leave_slot();
  name_.clear();
}

void UnfinishedFile::leave_slot() {
  if (slot_ == kSlots) return;
  if (names[slot_].exchange(nullptr) == nullptr) wait_for_the_end();
  slot_ = kSlots;
}

void remove_unfinished_files_on_signals() {
  struct sigaction ending {};
  ending.sa_handler = end_program;
  ending.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU}) {
    struct sigaction old {};
    sigaction(number, nullptr, &old);
    if (old.sa_handler != SIG_IGN) sigaction(number, &ending, nullptr);
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace thinbench
