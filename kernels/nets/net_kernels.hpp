// The kernels that evaluate nets.
#pragma once

#include "nets/model.hpp"
#include "thinning/engines/passes.hpp"

namespace thinbench::detail {

/// One kind of arithmetic for the three kinds of net.
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
/// Null pointers where vectorised loops over bytes are slower than the reference.
struct AutovecNetKernels {
  NetPasses<Pass<std::uint8_t>> bytes;
};

}  // namespace thinbench::detail
