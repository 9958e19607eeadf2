// Access from baseline code to kernels that are compiled for every ISA.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

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

/// The kernels for an ISA chosen at run time.
template <class Kernels>
[[nodiscard]] const Kernels& kernels_of(Isa isa) {
  static constexpr auto table = []<std::size_t... i>(std::index_sequence<i...>) {
    return std::array{&Exported<Kernels, kAllIsas[i]>::kKernels...};
  }
  (std::make_index_sequence<kAllIsas.size()>{});
  return *table.at(static_cast<std::size_t>(isa));
}

}  // namespace thinbench::detail
