// The kernels that evaluate nets.
#pragma once

#include "techniques/net_model.hpp"
#include "techniques/passes.hpp"

namespace thinbench::detail {

/// The passes of one arithmetic for the three kinds of net.
template <class AnyPass>
struct NetPasses {
  AnyPass sigmoid;
  AnyPass linear;
  AnyPass cluster;
};

/// Compiled for every ISA.
struct FloatNetKernels {
  NetPasses<ChangePass> bits;
};
struct FixedPointKernels {
  ChangePass linear;  // two layers, linear threshold
};
/// Null on ISAs where vectorised loops over bytes are slower than the reference.
struct AutovecNetKernels {
  NetPasses<Pass<std::uint8_t>> bytes;
};

}  // namespace thinbench::detail
