// Nets in single precision, one pixel per lane. Compiled for every ISA.
//
// Reads packed bits and evaluates changed neighbourhoods only (changed_pixels.hpp); a word of
// neighbours is the mask of an addition.
#include "core/exported.hpp"
#include "techniques/changed_pixels.hpp"
#include "techniques/float_nets.hpp"
#include "techniques/net_kernels.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

template <class Net>
struct FloatDecider {
  static constexpr Index kLanes = kFloatLanes;
  const NetModel& model;

  [[gnu::always_inline]] std::uint64_t operator()(const PackedNeighbours& neighbours,
                                                  Index first) const {
    return Net::decide(model, mask_inputs(neighbours, first));
  }
};

template <class Net>
std::uint64_t float_bits(const TableRule* rule, const std::uint64_t* fixed,
                         const ConstBitPlaneView& previous, const ConstBitPlaneView& source,
                         const BitPlaneView& target, const Band& band) {
  return decide_changed(FloatDecider<Net>{net_of(rule)}, fixed, previous, source, target, band);
}

using Sigmoid = TwoLayerNet<Activation::sigmoid>;
using Linear = TwoLayerNet<Activation::linear>;

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const FloatNetKernels Exported<FloatNetKernels, kThisIsa>::kKernels = {
    {&float_bits<Sigmoid>, &float_bits<Linear>, &float_bits<ClusterOfNets>}};

}  // namespace thinbench::detail
