// Evaluates a decision diagram on words of any type, one multiplexer per node.
#pragma once

#include "thinning/rules/neighbourhood.hpp"
#include "thinning/runtime_rule.hpp"

namespace thinbench::detail {

/// Any rule of eight neighbours, given at run time. Cost per word and node: 3 loads, 1 multiplexer
/// (one instruction on AVX-512, else three) and 1 store, more than a minimised circuit.
struct MuxRule {
  static constexpr int kSubIterations = 1;

  const MuxProgram& program;

  template <int sub, class Word>
  [[gnu::always_inline]] Word next(const Neighbourhood<Word>& n) const {
    const Word neighbour[kNeighbours] = {n.n0, n.n1, n.n2, n.n3, n.n4, n.n5, n.n6, n.n7};
    Word value[2 + MuxProgram::kMaxNodes];
    value[0] = n.p ^ n.p;
    value[1] = ~value[0];
    const int count = program.count;
    for (int i = 0; i < count; ++i) {
      const MuxNode node = program.nodes[i];
      value[2 + i] = ternary(neighbour[node.variable], value[node.high], value[node.low],
                             [](auto a, auto b, auto c) { return c ^ (a & (b ^ c)); });
    }
    return n.p & value[1 + count];
  }
};

}  // namespace thinbench::detail
