// The variants of an operation whose rule is fixed at compile time.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <tuple>

#include "thinning/iterate.hpp"
#include "thinning/variant.hpp"

namespace thinbench {

/// The passes of one rule out of an engine's table.
template <class Rule, class T>
constexpr std::span<const Pass<T>> cycle(const PassTable<T>& table) {
  static_assert(Rule::kSubIterations <= TileActivity::kLongestCycle);
  return {&table.passes[first_step<Rule>(AllRules{})], Rule::kSubIterations};
}

template <class... Arrays>
constexpr auto joined(const Arrays&... arrays) {
  std::array<ThinningVariant, (std::tuple_size_v<Arrays> + ...)> all{};
  std::size_t next = 0;
  const auto append = [&](const auto& rows) {
    for (const ThinningVariant& row : rows) all[next++] = row;
  };
  (append(arrays), ...);
  return all;
}

/// For rules of one stage: a neighbourhood of nine pixels is the index of a table.
template <class Rule>
constexpr auto table_rows() {
  using enum Technique;
  constexpr Isa base = Isa::kBaseline;
  return std::array{
      ThinningVariant{kLut, base, kOneThread, kAnyWidth, cycle<Rule>(ScalarPasses::kLut)},
      ThinningVariant{kLut, base, kThreaded, kAnyWidth, cycle<Rule>(ScalarPasses::kLut)},
      ThinningVariant{kLutSliding, base, kOneThread, kAnyWidth,
                      cycle<Rule>(ScalarPasses::kLutSliding)},
  };
}

template <class Rule>
constexpr auto scalar_rows() {
  using enum Technique;
  constexpr Isa base = Isa::kBaseline;
  return std::array{
      ThinningVariant{kBitpacked, base, kOneThread, kAnyWidth,
                      cycle<Rule>(ScalarPasses::kBitpacked)},
      ThinningVariant{kBitpacked, base, kThreaded, kAnyWidth,
                      cycle<Rule>(ScalarPasses::kBitpacked)},
  };
}

template <class Rule, Isa isa>
constexpr auto isa_rows() {
  using enum Technique;
  using Passes = IsaPasses<isa>;
  return std::array{
      ThinningVariant{kAutovec, isa, kOneThread, kAnyWidth, cycle<Rule>(Passes::kAutovec)},
      ThinningVariant{kSimdBytes, isa, kOneThread, kAnyWidth, cycle<Rule>(Passes::kSimdBytes)},
      ThinningVariant{kSimdBitpacked, isa, kOneThread, kAnyWidth,
                      cycle<Rule>(Passes::kSimdBitpacked)},
      ThinningVariant{kSimdBitpacked, isa, kThreaded, kAnyWidth,
                      cycle<Rule>(Passes::kSimdBitpacked)},
  };
}

/// The sub-iterations of one rule over tiles.
template <class Rule, Isa isa>
constexpr TileEngine tile_cycle() {
  static_assert(Rule::kSubIterations <= TileGridView::kLongestCycle);
  const TileVisit* first = &TilePasses<isa>::kTable.passes[first_step<Rule>(AllRules{})];
  return {{first, Rule::kSubIterations},
          &TilePasses<isa>::kListActive,
          &TilePasses<isa>::kFindKept,
          &TilePasses<isa>::kLayout};
}

template <class Rule, Isa isa>
constexpr auto tile_rows() {
  constexpr Technique tiles = Technique::kSimdBitpackedTiles;
  return std::array{ThinningVariant{tiles, isa, kOneThread, kAnyWidth, tile_cycle<Rule, isa>()},
                    ThinningVariant{tiles, isa, kThreaded, kAnyWidth, tile_cycle<Rule, isa>()}};
}

template <class Rule>
constexpr auto all_tile_rows() {
  return joined(tile_rows<Rule, Isa::kBaseline>(), tile_rows<Rule, Isa::kSse42>(),
                tile_rows<Rule, Isa::kAvx2>(), tile_rows<Rule, Isa::kAvx512>(),
                tile_rows<Rule, Isa::kAvx512Icl>());
}

template <class Rule, Isa isa>
constexpr auto row_kernel_rows() {
  return std::array{
      ThinningVariant{Technique::kSimdBitpackedRow, isa, kOneThread, kRowKernelWidth,
                      &RowKernels<isa>::kTable.kernels[rule_index<Rule>(AllRules{})]}};
}

/// Techniques that know either way of treating the border.
template <class Rule>
constexpr auto rows_of_either_border() {
  constexpr auto rows = joined(scalar_rows<Rule>(), isa_rows<Rule, Isa::kBaseline>(),
                               isa_rows<Rule, Isa::kSse42>(), isa_rows<Rule, Isa::kAvx2>(),
                               isa_rows<Rule, Isa::kAvx512>(), isa_rows<Rule, Isa::kAvx512Icl>());
  if constexpr (TwoStageRule<Rule>) {
    return rows;
  } else {
    return joined(table_rows<Rule>(), rows);
  }
}

/// All techniques for one rule: what a new operation gets for free.
template <class Rule>
const auto& rows_of() {
  static constexpr auto rows =
      joined(rows_of_either_border<Rule>(), row_kernel_rows<Rule, Isa::kAvx512>(),
             row_kernel_rows<Rule, Isa::kAvx512Icl>(), all_tile_rows<Rule>());
  return rows;
}

/// The same for an operation that keeps the border.
template <class Rule>
const auto& border_keeping_rows_of() {
  static constexpr auto rows = rows_of_either_border<Rule>();
  return rows;
}

}  // namespace thinbench
