// What a library writes to the process's standard error, caught instead of shown.
#pragma once

#include <string>

namespace thinbench {

/// Catches everything that is written to file descriptor 2 while it lives: image decoders print
/// there on their own. It acts on the whole process, so keep it short.
class CapturedStderr {
 public:
  CapturedStderr();
  ~CapturedStderr();
  CapturedStderr(const CapturedStderr&) = delete;
  CapturedStderr& operator=(const CapturedStderr&) = delete;
  CapturedStderr(CapturedStderr&&) = delete;
  CapturedStderr& operator=(CapturedStderr&&) = delete;

  /// What was written so far, up to 64 KiB; empty where nothing could be caught.
  [[nodiscard]] std::string text() const;

 private:
  int original_;
  int caught_;
};

}  // namespace thinbench
