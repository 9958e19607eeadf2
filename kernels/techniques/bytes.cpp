// The word scan on one pixel per byte lane. Compiled once for every ISA.
//
// Cost per register: 3 loads (2 of them unaligned, for neighbours), 1 store, the rule's gates. Each
// operation computes an eighth of the pixels of packed words.
#include "core/exported.hpp"
#include "scan/layouts.hpp"
#include "techniques/scalar.hpp"

namespace thinbench::detail {

template <>
constinit const ByteScans Exported<ByteScans, kThisIsa>::kKernels = {
    static_cast<Index>(ByteBatch::size), scan_functions_by_rule<PlaneRows<ByteBatch>>()};

}  // namespace thinbench::detail
