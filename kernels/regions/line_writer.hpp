// Writes rows of labels past the caches. For ISA files only.
#pragma once

#include <cstdint>
#include <cstring>

#include "simd/vector.hpp"

namespace thinbench::detail {

/// Label images of at least this many bytes are written with non-temporal stores: below, they cost
/// more than they save, as the labels are still in the cache for whoever reads them.
inline constexpr Index kNonTemporalLabelBytes = Index{4} << 20;

inline namespace THINBENCH_ISA {

/// Non-temporal stores must fill cache lines: labels at the end of what is written wait until their
/// line is complete. The lines at the ends of all that is contiguous take ordinary stores.
class LineWriter {
 public:
  static constexpr Index kLine = 16;  // labels

  /// Where to make labels that write() takes: `room` has kLine elements more than these, and is
  /// aligned to a line.
  [[gnu::always_inline]] static std::uint32_t* start_in(std::uint32_t* room,
                                                        const std::uint32_t* to) {
    return room + offset_of(to);
  }

  /// Writes `count` labels, which start_in() has placed.
  [[gnu::always_inline]] void write(std::uint32_t* to, std::uint32_t* from, Index count) {
    if (to != next_) flush();
    if (pending_ > 0) {
      from -= pending_;
      to -= pending_;
      count += pending_;
      copy(from, line_, pending_);
    } else if (const Index offset = offset_of(to); offset != 0) {
      const Index rest = kLine - offset < count ? kLine - offset : count;
      copy(to, from, rest);
      from += rest;
      to += rest;
      count -= rest;
    }
    for (; count >= kLine; count -= kLine, from += kLine, to += kLine) write_line(to, from);
    copy(line_, from, count);
    pending_ = count;
    next_ = to + count;
  }

  /// Writes what waits.
  [[gnu::always_inline]] void flush() {
    copy(next_ - pending_, line_, pending_);
    pending_ = 0;
  }

 private:
  [[gnu::always_inline]] static Index offset_of(const std::uint32_t* to) {
    return static_cast<Index>(reinterpret_cast<std::uintptr_t>(to) / sizeof(*to)) % kLine;
  }
  [[gnu::always_inline]] static void copy(std::uint32_t* to, const std::uint32_t* from,
                                          Index count) {
    for (Index i = 0; i < count; ++i) to[i] = from[i];
  }
  [[gnu::always_inline]] static void write_line(std::uint32_t* to, const std::uint32_t* from) {
    constexpr Index lanes = static_cast<Index>(Lanes32::size);
    for (Index i = 0; i < kLine; i += lanes) {
      store_non_temporal(reinterpret_cast<std::uint8_t*>(to + i),
                         reinterpreted<ByteBatch>(Lanes32::load_aligned(from + i)));
    }
  }

  std::uint32_t line_[kLine];
  std::uint32_t* next_ = nullptr;  // after the last label
  Index pending_ = 0;              // labels before it that wait
};

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
