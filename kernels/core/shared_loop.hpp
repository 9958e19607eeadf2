// A loop whose parts threads take as they come, offered by one thread to whoever is awake.
#pragma once

#include <atomic>
#include <bit>
#include <cstdint>
#include <thread>

#include "core/views.hpp"

namespace thinbench {

/// One thread offers loops, one after another; helpers take parts of them until it is over. The
/// offering thread takes parts, too, so it never depends on a helper that has not come yet.
class SharedLoop {
 public:
  using Part = void (*)(const void* body, Index part, Index parts);

  /// Runs all parts, at most 65,535, and returns when they are done. Offering thread only.
  void offer(Part run_part, const void* body, Index parts) {
    run_part_ = run_part;
    body_ = body;
    done_.store(0, std::memory_order_relaxed);
    const Ticket last = ticket_of(ticket_.load(std::memory_order_relaxed));
    ticket_.store(word_of({last.loop + 1, static_cast<std::uint16_t>(parts), 0}),
                  std::memory_order_release);
    while (take_part()) continue;
    Patience patience;
    while (done_.load(std::memory_order_acquire) != parts) patience.wait();
  }

  /// No more loops: helpers return.
  void close() { closed_.store(true, std::memory_order_release); }

  /// Takes parts until the end.
  void help() {
    Patience patience;
    while (!closed_.load(std::memory_order_acquire)) {
      if (take_part()) {
        patience = {};
      } else {
        patience.wait();
      }
    }
  }

 private:
  /// The next part of a loop. All in one word, so that nobody takes a part of a loop that is over.
  struct Ticket {
    std::uint32_t loop;
    std::uint16_t parts;
    std::uint16_t next;
  };
  static Ticket ticket_of(std::uint64_t word) { return std::bit_cast<Ticket>(word); }
  static std::uint64_t word_of(Ticket ticket) { return std::bit_cast<std::uint64_t>(ticket); }

  /// Waits shortly, later lets others run.
  class Patience {
   public:
    void wait() {
      constexpr int before_yielding = 2000;
      if (++waits_ < before_yielding) {
        __builtin_ia32_pause();
      } else {
        std::this_thread::yield();
      }
    }

   private:
    int waits_ = 0;
  };

  /// Whoever holds part i of a loop may read what belongs to the loop: the offering thread changes
  /// nothing before that part is done.
  bool take_part() {
    std::uint64_t word = ticket_.load(std::memory_order_acquire);
    for (;;) {
      Ticket ticket = ticket_of(word);
      if (ticket.next >= ticket.parts) return false;
      const Index part = ticket.next++;
      if (!ticket_.compare_exchange_weak(word, word_of(ticket), std::memory_order_acq_rel,
                                         std::memory_order_acquire)) {
        continue;
      }
      run_part_(body_, part, ticket.parts);
      done_.fetch_add(1, std::memory_order_release);
      return true;
    }
  }

  alignas(64) std::atomic<std::uint64_t> ticket_{0};
  alignas(64) std::atomic<Index> done_{0};
  Part run_part_ = nullptr;
  const void* body_ = nullptr;
  std::atomic<bool> closed_{false};
};

}  // namespace thinbench
