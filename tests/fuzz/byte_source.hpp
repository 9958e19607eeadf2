// What a fuzz target draws from its input, and how it says that something is wrong.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

namespace thinbench {

/// Ends the program, so that the input is kept, unless `condition` holds.
inline void must(bool condition, const std::string& what) {
  if (condition) return;
  std::fprintf(stderr, "fuzz target: %s\n", what.c_str());
  std::abort();
}

/// Whether a message is one line with something in it.
inline void must_be_one_line(std::string_view message) {
  must(!message.empty() && message.find('\n') == std::string_view::npos,
       "not one line: '" + std::string(message) + "'");
}

/// What `call` throws must be an error of this type with one line.
template <class Error, class Call>
void must_succeed_or_explain(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    must_be_one_line(error.what());
  }
}

/// Takes values from the front of an input; zeros where it has ended.
class ByteSource {
 public:
  ByteSource(const std::uint8_t* data, std::size_t size) : bytes_(data, size) {}

  [[nodiscard]] bool is_empty() const { return bytes_.empty(); }

  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t value = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return value;
  }

  /// Little-endian.
  std::uint64_t word() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 8) value |= std::uint64_t{byte()} << shift;
    return value;
  }

  /// From `low` to `high`, which are less than 2^16 apart.
  std::ptrdiff_t number(std::ptrdiff_t low, std::ptrdiff_t high) {
    const std::ptrdiff_t count = high - low + 1;
    const std::ptrdiff_t drawn = count <= 256 ? byte() : byte() | byte() << 8;
    return low + drawn % count;
  }

  /// True once in `count` times.
  bool once_in(int count) { return number(0, count - 1) == count - 1; }

  /// An element of a list that outlives the result.
  template <class List>
  const auto& pick(const List& list) {
    const auto last = static_cast<std::ptrdiff_t>(std::size(list)) - 1;
    return list[static_cast<std::size_t>(number(0, last))];
  }

  std::span<const std::uint8_t> take(std::size_t count) {
    const auto taken = bytes_.first(std::min(count, bytes_.size()));
    bytes_ = bytes_.subspan(taken.size());
    return taken;
  }

  /// Up to the next zero byte or newline, which is taken, too.
  std::string line() {
    const auto end = std::find_if(bytes_.begin(), bytes_.end(),
                                  [](std::uint8_t c) { return c == 0 || c == '\n'; });
    const auto taken = take(static_cast<std::size_t>(end - bytes_.begin()));
    static_cast<void>(byte());
    return {taken.begin(), taken.end()};
  }

  std::string rest() {
    const auto taken = take(bytes_.size());
    return {taken.begin(), taken.end()};
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

/// What a target does with an input: the program ends unless all is as it should be.
void try_input(ByteSource& input);

}  // namespace thinbench
