// Access from baseline code to kernels that are compiled per ISA.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/features.hpp"
#include "core/isas.hpp"  // generated: kIsas
#include "thinbench/isa.hpp"

namespace thinbench::detail {

/// What the kernels of a family gain from. SSE4.2 gains too little for most: docs/platforms.md.
template <class Kernels>
inline constexpr Features kGainsFrom = ~kSse42;

/// Whether a family is compiled for one of kIsas: for the baseline, and for ISAs that add to those
/// before them what the family gains from.
template <class Kernels>
constexpr bool is_compiled_for(Isa isa) {
  Features before = 0;
  for (std::size_t i = 0; kIsas[i] != isa; ++i) before |= features_of(kIsas[i]);
  return isa == Isa::baseline || (features_of(isa) & ~before & kGainsFrom<Kernels>) != 0;
}

/// The ISAs for which one of these families is compiled.
template <class... Kernels>
[[nodiscard]] std::vector<Isa> isas_of() {
  std::vector<Isa> isas;
  for (const Isa isa : kIsas) {
    if ((is_compiled_for<Kernels>(isa) || ...)) isas.push_back(isa);
  }
  return isas;
}

/// The kernels of one family for one ISA: a plain struct of function pointers. The family's source
/// file defines it in each of its compilations:
///   template <>
///   constinit const SomeKernels Exported<SomeKernels, kThisIsa>::kKernels = {...};
template <class Kernels, Isa isa>
requires(is_compiled_for<Kernels>(isa)) struct Exported {
  static const Kernels kKernels;
};

/// The kernels for one of kIsas, or for the next lower one for which the family is compiled.
template <class Kernels>
[[nodiscard]] const Kernels& kernels_of(Isa isa) {
  const Kernels* found = &Exported<Kernels, Isa::baseline>::kKernels;
  const auto consider = [&]<Isa one>(std::integral_constant<Isa, one>) {
    if constexpr (is_compiled_for<Kernels>(one)) {
      if (one <= isa) found = &Exported<Kernels, one>::kKernels;
    }
  };
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (consider(std::integral_constant<Isa, kIsas[i]>{}), ...);
  }
  (std::make_index_sequence<kIsas.size()>{});
  return *found;
}

}  // namespace thinbench::detail
