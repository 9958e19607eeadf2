// Weights of a cluster of single-layer nets (section 3.3) that is right on all 256 descriptors of
// the modified Naccache-Shinghal rule, with as few nets as possible. Made by
//     thinbench-study train cluster --integer --header kernels/rules/trained_cluster.hpp
#pragma once

#include "thinbench/nets.hpp"

namespace thinbench::detail {

inline constexpr ClusterWeights kTrainedCluster = {
    12,
    {{67, {{-1.0F, 0.0F, -3.0F, 0.0F, -2.0F, 1.0F, -3.0F, 0.0F}, 3.0F}},
     {84, {{-2.0F, 1.0F, -2.0F, 0.0F, -3.0F, 0.0F, 2.0F, 0.0F}, 0.0F}},
     {89, {{1.0F, 0.0F, 0.0F, -1.0F, 0.0F, 0.0F, -1.0F, 0.0F}, 0.0F}},
     {96, {{1.0F, 0.0F, -1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F}, 0.0F}},
     {116, {{-2.0F, 1.0F, 0.0F, 2.0F, -1.0F, 0.0F, 0.0F, 0.0F}, 0.0F}},
     {121, {{1.0F, 0.0F, 0.0F, -1.0F, 0.0F, 0.0F, -1.0F, 0.0F}, 0.0F}},
     {132, {{1.0F, 0.0F, -1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 1.0F}, 0.0F}},
     {207, {{-3.0F, 0.0F, -2.0F, 1.0F, 1.0F, 3.0F, 0.0F, 2.0F}, 0.0F}},
     {212, {{-1.0F, 1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, -1.0F}, 0.0F}},
     {224, {{1.0F, 2.0F, 1.0F, -1.0F, -1.0F, 0.0F, 0.0F, 0.0F}, 0.0F}},
     {244, {{-2.0F, 1.0F, 0.0F, 2.0F, -1.0F, 0.0F, 0.0F, 0.0F}, 0.0F}},
     {255, {{1.0F, 2.0F, 1.0F, 0.0F, 0.0F, 0.0F, -1.0F, -1.0F}, 0.0F}}}};

}  // namespace thinbench::detail
