// Instruction sets: tests that run once for each, skipped where it is not available, and their
// names.
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

/// What messages list as the instruction sets of this architecture.
inline std::string all_isa_names() {
  std::string names;
  for (const Isa isa : all_isas()) names.append(names.empty() ? "" : ", ").append(isa_name(isa));
  return names;
}

}  // namespace thinbench
