#include "custom/variants.hpp"

#include <array>
#include <utility>

#include "custom/compiled_rule.hpp"
#include "dispatch/exported.hpp"
#include "thinning/iteration/pass_state.hpp"
#include "thinning/iteration/row_state.hpp"
#include "thinning/iteration/tile_state.hpp"
#include "thinning/variants.hpp"

namespace thinbench::detail {
namespace {

using enum Technique;
using State = std::unique_ptr<ThinningState>;

/// Applies sub-iteration `sub` of a BoundRule to columns of registers.
template <std::size_t sub>
std::uint64_t pass(const RuntimeRule* runtime_rule, const std::uint64_t* fixed,
                   const ConstBitPlaneView& source, const BitPlaneView& target, const Band& band) {
  constexpr auto bytes = static_cast<Index>(sizeof(std::uint64_t));
  const auto& rule = *static_cast<const BoundRule*>(runtime_rule);
  const Index rows = band.last - band.first;
  std::uint64_t changed = 0;
  for (Index x = 0; x < source.row_elements; x += rule.register_words) {
    const std::uint64_t columns = band.columns & band.columns_of(x, x + rule.register_words);
    if (columns == 0) continue;
    const std::uint64_t any = rule.scans[sub]({.source = source.row(band.first) + x,
                                               .source_stride = source.stride * bytes,
                                               .target = target.row(band.first) + x,
                                               .target_stride = target.stride * bytes,
                                               .rows = rows,
                                               .band_rows = rows,
                                               .fixed = fixed == nullptr ? nullptr : fixed + x});
    if (any != 0) changed |= columns;
  }
  return changed;
}

constexpr auto kPasses = []<std::size_t... subs>(std::index_sequence<subs...>) {
  return std::array<Pass<std::uint64_t>, sizeof...(subs)>{&pass<subs>...};
}
(std::make_index_sequence<kMaxSubIterations>{});

/// Whether scans get fixed pixels.
bool has_fixed(const ThinningSetting& setting) {
  return setting.border == Border::keep || setting.custom_rule->adds_pixels();
}

/// The setting for engines, with a rule that keeps the compiled one alive.
ThinningSetting bound(const ThinningSetting& setting, const BoundRule& rule) {
  struct Owner {
    std::shared_ptr<const CompiledRule> compiled;
    BoundRule rule;
  };
  ThinningSetting result = setting;
  const auto owner = std::make_shared<const Owner>(Owner{setting.custom_rule, rule});
  result.runtime_rule = {owner, &owner->rule};
  return result;
}

State make_words(const ThinningSetting& setting, const BoundRule& rule) {
  const auto count = static_cast<std::size_t>(rule.sub_iterations);
  return std::make_unique<PassState<std::uint64_t>>(std::span(kPasses).first(count),
                                                    bound(setting, rule));
}

}  // namespace

State make_custom_bitpacked(const ThinningSetting& setting) {
  return make_words(setting, setting.custom_rule->bind_scalar());
}

State make_custom_simd_bitpacked(const ThinningSetting& setting) {
  return make_words(setting,
                    setting.custom_rule->bind(setting.isa, Layout::words, has_fixed(setting)));
}

State make_custom_row(const ThinningSetting& setting) {
  const BoundRule rule = setting.custom_rule->bind(setting.isa, Layout::row, has_fixed(setting));
  return std::make_unique<RowState>(kernels_of<RowKernels>(setting.isa).custom,
                                    bound(setting, rule));
}

namespace {

/// Tiles, for rules that add no pixels. They need machine code; if the system denies it although it
/// did not before, words compute the same.
State make_custom_tiles(const ThinningSetting& setting) {
  const BoundRule rule = setting.custom_rule->bind(setting.isa, Layout::tiles, false);
  for (int i = 0; i < rule.sub_iterations; ++i) {
    const BoundScan& scan = rule.scans[static_cast<std::size_t>(i)];
    if (scan.function == nullptr) return make_custom_simd_bitpacked(setting);
  }
  const ThinningSetting with_rule = bound(setting, rule);
  const TileKernels& kernels = kernels_of<TileKernels>(setting.isa);
  const auto count = static_cast<std::size_t>(rule.sub_iterations);
  return std::make_unique<TileState>(
      TileEngine{std::span(kernels.custom).first(count), &kernels,
                 &kernels_of<TileLayout>(setting.isa), with_rule.runtime_rule.get()},
      with_rule);
}

}  // namespace

std::vector<ThinningVariant> custom_variants(bool adds_pixels) {
  ThinningVariants list;
  list.add_with_threads(bitpacked, Isa::baseline, &make_custom_bitpacked, {kBitpackedPriority});
  for (const Isa isa : all_isas()) {
    list.add_with_threads(simd_bitpacked, isa, &make_custom_simd_bitpacked,
                          {kSimdBitpackedPriority});
    if (!adds_pixels && MachineCode::is_available(isa)) {
      list.add_with_threads(simd_bitpacked_tiles, isa, &make_custom_tiles, {kTilesPriority});
    }
    if (kernels_of<RowKernels>(isa).custom != nullptr) {
      list.add(simd_bitpacked_row, isa, &make_custom_row, {kRowPriority, kRowKernelWidth});
    }
  }
  return list.take();
}

}  // namespace thinbench::detail
