// The passes of engines that take their rule from a model.
#pragma once

#include "core/isa.hpp"
#include "thinning/passes.hpp"

namespace thinbench {

/// Compiled once, for the baseline.
struct ScalarModelPasses {
  static const Pass<std::uint8_t> kLut;
  static const Pass<std::uint8_t> kLutSliding;
  static const Pass<std::uint64_t> kBitpacked;
};

/// One form of arithmetic for the three kinds of net.
template <class T>
struct NetPasses {
  Pass<T> sigmoid;
  Pass<T> linear;
  Pass<T> cluster;
};

/// For judging the arithmetic: the answer of hidden neuron j to descriptor k goes to values[256 j +
/// k].
struct HiddenValues {
  void (*sigmoid)(const RuleModel& model, float* values);
  void (*linear)(const RuleModel& model, float* values);
};

/// Compiled once for every instruction-set level.
template <Isa isa>
struct IsaModelPasses {
  static const Pass<std::uint64_t> kSimdBitpacked;
  static const NetPasses<std::uint8_t> kAutovec;
  static const NetPasses<std::uint8_t> kFloatBytes;
  static const NetPasses<std::uint64_t> kFloatBits;
  static const HiddenValues kHiddenValues;
  static const Pass<std::uint64_t> kFixedPointBits;  // two layers, linear threshold
};

}  // namespace thinbench
