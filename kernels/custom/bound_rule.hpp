// A custom rule that is ready to run on one ISA and layout. Plain data, safe to include in files of
// every ISA.
#pragma once

#include <array>

#include "custom/column_scan.hpp"
#include "thinning/engines/passes.hpp"

namespace thinbench::detail {

struct BoundRule : RuntimeRule {
  std::array<BoundScan, kMaxSubIterations> scans = {};
  int sub_iterations = 0;
  Index register_words = 1;
};

}  // namespace thinbench::detail
