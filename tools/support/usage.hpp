// Exit statuses, and what ends a program with one of them.
#pragma once

#include <stdexcept>
#include <string>

namespace thinbench {

inline constexpr int kSuccess = 0;
inline constexpr int kFailure = 1;
inline constexpr int kUsage = 2;
inline constexpr int kNothingFound = 3;

/// The program was given something that does not exist; ends it with kUsage.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What was looked for does not exist; ends the program with kNothingFound.
struct NothingFound : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Does work, of which std::invalid_argument becomes a UsageError that begins with `before`.
template <class Work>
auto checked_usage(const Work& work, const char* before = "") {
  try {
    return work();
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string(before) + error.what());
  }
}

}  // namespace thinbench
