// Access from baseline code to kernels that are compiled for every ISA.
#pragma once

#include <cstddef>
#include <utility>

#include "core/isas.hpp"  // generated: kIsas
#include "thinbench/isa.hpp"

namespace thinbench::detail {

/// The kernels of one family for one ISA: a plain struct of function pointers. The family's source
/// file defines it in each of its compilations:
///   template <>
///   constinit const SomeKernels Exported<SomeKernels, kThisIsa>::kKernels = {...};
template <class Kernels, Isa isa>
struct Exported {
  static const Kernels kKernels;
};

/// The kernels for one of kIsas, chosen at run time.
template <class Kernels>
[[nodiscard]] const Kernels& kernels_of(Isa isa) {
  return [isa]<std::size_t... i>(std::index_sequence<i...>)->const Kernels& {
    const Kernels* found = nullptr;
    ((kIsas[i] == isa ? void(found = &Exported<Kernels, kIsas[i]>::kKernels) : void()), ...);
    return *found;
  }
  (std::make_index_sequence<kIsas.size()>{});
}

}  // namespace thinbench::detail
