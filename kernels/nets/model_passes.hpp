// The passes of engines that take their rule from a model.
#pragma once

#include "dispatch/isa.hpp"
#include "thinning/engines/passes.hpp"

namespace thinbench::detail {

/// Compiled once, for the baseline.
struct ScalarModelPasses {
  static const Pass<std::uint8_t> kLut;
  static const Pass<std::uint8_t> kLutSliding;
  static const Pass<std::uint64_t> kBitpacked;
};

/// One form of arithmetic for the three kinds of net.
template <class AnyPass>
struct NetPasses {
  AnyPass sigmoid;
  AnyPass linear;
  AnyPass cluster;
};

/// For judging the arithmetic: the answer of hidden neuron j to descriptor k goes to values[256 j +
/// k], and that of the output neuron follows as if it were the last of them.
struct NeuronValues {
  void (*sigmoid)(const RuleModel& model, float* values);
  void (*linear)(const RuleModel& model, float* values);
};

/// Compiled once for every instruction-set level.
template <Isa isa>
struct IsaModelPasses {
  static const Pass<std::uint64_t> kSimdBitpacked;
  static const NetPasses<Pass<std::uint8_t>> kAutovec;
  static const NetPasses<Pass<std::uint8_t>> kFloatBytes;
  static const NetPasses<ChangePass> kFloatBits;
  static const NeuronValues kNeuronValues;
  static const ChangePass kFixedPointBits;  // two layers, linear threshold
};

}  // namespace thinbench::detail
