// THINBENCH_MAX_ISA, set for a part of a test.
#pragma once

#include <cstdlib>
#include <optional>
#include <string>

#include "thinbench/isa.hpp"

namespace thinbench {

/// Sets the variable and restores its old value when destroyed.
class IsaCap {
 public:
  explicit IsaCap(const char* cap) {
    if (const char* old = std::getenv(kIsaCapVariable)) old_ = old;
    setenv(kIsaCapVariable, cap, 1);
  }
  ~IsaCap() { old_ ? setenv(kIsaCapVariable, old_->c_str(), 1) : unsetenv(kIsaCapVariable); }
  IsaCap(const IsaCap&) = delete;
  IsaCap& operator=(const IsaCap&) = delete;
  IsaCap(IsaCap&&) = delete;
  IsaCap& operator=(IsaCap&&) = delete;

 private:
  std::optional<std::string> old_;
};

}  // namespace thinbench
