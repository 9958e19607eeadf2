// What a library writes to standard error, caught instead of shown.
#pragma once

#include <string>

namespace thinbench {

/// Catches what its thread writes to C's `stderr` and to std::cerr while it lives: image decoders
/// print there on their own. Other threads are not affected.
class CapturedStderr {
 public:
  CapturedStderr();
  ~CapturedStderr();
  CapturedStderr(const CapturedStderr&) = delete;
  CapturedStderr& operator=(const CapturedStderr&) = delete;
  CapturedStderr(CapturedStderr&&) = delete;
  CapturedStderr& operator=(CapturedStderr&&) = delete;

  /// What was written so far, about 64 KiB at most.
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::string* outer_;  // of the capture around this one, if any
};

}  // namespace thinbench
