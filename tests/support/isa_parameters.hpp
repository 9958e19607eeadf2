// Tests that run once for every ISA; skipped where the ISA is not available.
#pragma once

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

}  // namespace thinbench
