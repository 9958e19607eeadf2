// Exit statuses, and what ends a program with one of them.
#pragma once

#include <stdexcept>

namespace thinbench {

inline constexpr int kSuccess = 0;
inline constexpr int kFailure = 1;
inline constexpr int kUsage = 2;

/// The program was given something that does not exist; ends it with kUsage.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace thinbench
