// Edges as compilers vectorise them. Plain data, safe to include in files of every ISA.
#pragma once

#include "edges/kernels.hpp"

namespace thinbench::detail {

struct AutovecEdgeKernels {
  EdgeTable<EdgesToBytes> bytes;
};
template <>
inline constexpr Features kGainsFrom<AutovecEdgeKernels> = kEdgeFeatures;

}  // namespace thinbench::detail
