// The variants of an operation whose rule is fixed at compile time.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <tuple>

#include "thinning/iteration/iterate.hpp"
#include "thinning/variant.hpp"

namespace thinbench::detail {

/// The passes of one rule out of an engine's table.
template <class Rule, class T>
constexpr std::span<const Pass<T>> cycle(const PassTable<T>& table) {
  static_assert(Rule::kSubIterations <= TileActivity::kMaxSubIterations);
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
  constexpr Isa base = Isa::baseline;
  return std::array{
      ThinningVariant{lut, base, kOneThread, kAnyWidth, cycle<Rule>(ScalarPasses::kLut)},
      ThinningVariant{lut, base, kThreaded, kAnyWidth, cycle<Rule>(ScalarPasses::kLut)},
      ThinningVariant{lut_sliding, base, kOneThread, kAnyWidth,
                      cycle<Rule>(ScalarPasses::kLutSliding)},
  };
}

template <class Rule>
constexpr auto scalar_rows() {
  using enum Technique;
  constexpr Isa base = Isa::baseline;
  return std::array{
      ThinningVariant{bitpacked, base, kOneThread, kAnyWidth,
                      cycle<Rule>(ScalarPasses::kBitpacked)},
      ThinningVariant{bitpacked, base, kThreaded, kAnyWidth,
                      cycle<Rule>(ScalarPasses::kBitpacked)},
  };
}

template <class Rule, Isa isa>
constexpr auto isa_rows() {
  using enum Technique;
  using Passes = IsaPasses<isa>;
  return std::array{
      ThinningVariant{autovec, isa, kOneThread, kAnyWidth, cycle<Rule>(Passes::kAutovec)},
      ThinningVariant{simd_bytes, isa, kOneThread, kAnyWidth, cycle<Rule>(Passes::kSimdBytes)},
      ThinningVariant{simd_bitpacked, isa, kOneThread, kAnyWidth,
                      cycle<Rule>(Passes::kSimdBitpacked)},
      ThinningVariant{simd_bitpacked, isa, kThreaded, kAnyWidth,
                      cycle<Rule>(Passes::kSimdBitpacked)},
  };
}

/// The sub-iterations of one rule over tiles.
template <class Rule, Isa isa>
constexpr TileEngine tile_cycle() {
  static_assert(Rule::kSubIterations <= TileGridView::kMaxSubIterations);
  const TileVisit* first = &TilePasses<isa>::kTable.passes[first_step<Rule>(AllRules{})];
  return {{first, Rule::kSubIterations},
          &TilePasses<isa>::kListActive,
          &TilePasses<isa>::kFindHeld,
          &TilePasses<isa>::kLayout};
}

template <class Rule, Isa isa>
constexpr auto tile_rows() {
  constexpr Technique tiles = Technique::simd_bitpacked_tiles;
  return std::array{ThinningVariant{tiles, isa, kOneThread, kAnyWidth, tile_cycle<Rule, isa>()},
                    ThinningVariant{tiles, isa, kThreaded, kAnyWidth, tile_cycle<Rule, isa>()}};
}

template <class Rule>
constexpr auto all_tile_rows() {
  return joined(tile_rows<Rule, Isa::baseline>(), tile_rows<Rule, Isa::sse42>(),
                tile_rows<Rule, Isa::avx2>(), tile_rows<Rule, Isa::avx512>(),
                tile_rows<Rule, Isa::avx512icl>());
}

template <class Rule, Isa isa>
constexpr auto row_kernel_rows() {
  return std::array{
      ThinningVariant{Technique::simd_bitpacked_row, isa, kOneThread, kRowKernelWidth,
                      &RowKernels<isa>::kTable.kernels[rule_index<Rule>(AllRules{})]}};
}

/// Techniques that know either way of treating the border.
template <class Rule>
constexpr auto rows_of_either_border() {
  constexpr auto rows = joined(scalar_rows<Rule>(), isa_rows<Rule, Isa::baseline>(),
                               isa_rows<Rule, Isa::sse42>(), isa_rows<Rule, Isa::avx2>(),
                               isa_rows<Rule, Isa::avx512>(), isa_rows<Rule, Isa::avx512icl>());
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
      joined(rows_of_either_border<Rule>(), row_kernel_rows<Rule, Isa::avx512>(),
             row_kernel_rows<Rule, Isa::avx512icl>(), all_tile_rows<Rule>());
  return rows;
}

/// The same for an operation that keeps the border.
template <class Rule>
const auto& border_keeping_rows_of() {
  static constexpr auto rows = rows_of_either_border<Rule>();
  return rows;
}

}  // namespace thinbench::detail
