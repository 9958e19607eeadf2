// Instruction sets: tests that run once for each, skipped where it is not available, their names,
// and THINBENCH_MAX_ISA, set for a part of a test.
#pragma once

#include <cstdlib>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "thinbench/isa.hpp"

namespace thinbench {

class IsaTest : public testing::TestWithParam<Isa> {
 protected:
  void SetUp() override {
    if (!isa_available(GetParam())) GTEST_SKIP() << isa_name(GetParam()) << " is not available";
  }
};

inline std::string isa_test_name(const testing::TestParamInfo<Isa>& tested) {
  std::string name(isa_name(tested.param));
  std::erase_if(name, [](char c) { return c == '.' || c == '-'; });  // not allowed in test names
  return name;
}

/// What messages list as the instruction sets of this architecture.
inline std::string all_isa_names() {
  std::string names;
  for (const Isa isa : all_isas()) names.append(names.empty() ? "" : ", ").append(isa_name(isa));
  return names;
}

/// Why a test is skipped whose cap is not in force.
inline constexpr const char* kCapWasRead =
    "another ISA cap was read before; ctest runs this test alone";

/// Sets the variable; an empty cap is none.
inline void set_cap(const char* cap) {
#ifdef _WIN32
  _putenv_s(kIsaCapVariable, cap);
#else
  setenv(kIsaCapVariable, cap, 1);
#endif
}

/// Sets the variable and restores its old value when destroyed.
class IsaCap {
 public:
  explicit IsaCap(const char* cap) {
    if (const char* old = std::getenv(kIsaCapVariable)) old_ = old;
    set_cap(cap);
  }
  ~IsaCap() { set_cap(old_.c_str()); }
  IsaCap(const IsaCap&) = delete;
  IsaCap& operator=(const IsaCap&) = delete;

  /// A process reads the cap once: false where an earlier test of this process has made it do so.
  [[nodiscard]] bool is_in_force() const {
    try {
      const auto read = isa_cap();
      const char* const cap = std::getenv(kIsaCapVariable);
      return read && cap != nullptr && read == isa_from_name(cap);
    } catch (const std::invalid_argument&) {
      return true;  // it is read again until it is valid
    }
  }

 private:
  std::string old_;
};

}  // namespace thinbench
