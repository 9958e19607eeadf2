#include "nets/variants.hpp"

#include <algorithm>

#include "custom/compiled_rule.hpp"
#include "custom/variants.hpp"
#include "dispatch/exported.hpp"
#include "image/checks.hpp"
#include "nets/make_model.hpp"
#include "nets/net_kernels.hpp"
#include "nets/trained_cluster.hpp"
#include "thinning/engines/rule_table.hpp"
#include "thinning/iteration/pass_state.hpp"
#include "thinning/iteration/row_state.hpp"
#include "thinning/variants.hpp"

namespace thinbench::detail {
namespace {

using enum Technique;
using State = std::unique_ptr<ThinningState>;

template <class T>
State make_pass(const Pass<T>& pass, const ThinningSetting& setting) {
  return std::make_unique<PassState<T>>(std::span(&pass, 1), setting);
}

State make_net_lut(const ThinningSetting& setting) {
  return make_pass(ScalarPasses::kRuntimeLut, setting);
}
State make_net_lut_sliding(const ThinningSetting& setting) {
  return make_pass(ScalarPasses::kRuntimeLutSliding, setting);
}

/// Whether the net has the truth table of the Naccache-Shinghal rule, which has a minimised
/// circuit.
bool matches_naccache_shinghal(const ThinningSetting& setting) {
  static constexpr RuleTable kTable = make_rule_table<NaccacheShinghal, 0>();
  return std::equal(kTable.begin(), kTable.end(), net_of(setting.runtime_rule.get()).new_pixel);
}

ThinningSetting as_naccache_shinghal(ThinningSetting setting) {
  setting.rule = Rule::naccache_shinghal;
  return setting;
}

/// The net's decisions as a custom rule.
ThinningSetting as_custom_rule(ThinningSetting setting) {
  const std::uint8_t* const new_pixel = net_of(setting.runtime_rule.get()).new_pixel;
  const WindowTable table =
      make_window_table([&](std::size_t window) { return new_pixel[descriptor_of(window)] != 0; });
  setting.custom_rule = compile(std::span(&table, 1), kFastSearch);
  return setting;
}

State make_net_bitpacked(const ThinningSetting& setting) {
  if (matches_naccache_shinghal(setting)) return make_bitpacked(as_naccache_shinghal(setting));
  return make_custom_bitpacked(as_custom_rule(setting));
}

State make_net_simd_bitpacked(const ThinningSetting& setting) {
  if (matches_naccache_shinghal(setting)) return make_simd_bitpacked(as_naccache_shinghal(setting));
  return make_custom_simd_bitpacked(as_custom_rule(setting));
}

State make_net_row(const ThinningSetting& setting) {
  if (matches_naccache_shinghal(setting)) return make_row(as_naccache_shinghal(setting));
  return make_custom_row(as_custom_rule(setting));
}

template <class AnyPass>
const AnyPass& pass_of(const NetPasses<AnyPass>& passes, Rule rule) {
  if (rule == Rule::net_single_layer_cluster) return passes.cluster;
  return rule == Rule::net_two_layer_linear ? passes.linear : passes.sigmoid;
}

State make_net_autovec(const ThinningSetting& setting) {
  return make_pass(pass_of(kernels_of<AutovecNetKernels>(setting.isa).bytes, setting.rule),
                   setting);
}

State make_float_bits(const ThinningSetting& setting) {
  return std::make_unique<ChangeState>(
      pass_of(kernels_of<FloatNetKernels>(setting.isa).bits, setting.rule), setting);
}

State make_fixed_point(const ThinningSetting& setting) {
  require(net_of(setting.runtime_rule.get()).fixed_point_is_exact,
          "simd_fixed_point cannot run: no 8-bit weights reproduce the decisions of this net");
  return std::make_unique<ChangeState>(kernels_of<FixedPointKernels>(setting.isa).linear, setting);
}

void add_arithmetic(ThinningVariants& list, Rule rule, Isa isa) {
  if (kernels_of<AutovecNetKernels>(isa).bytes.sigmoid != nullptr) {
    list.add(autovec, isa, &make_net_autovec, {kAutovecPriority});
  }
  list.add_with_threads(simd_float_bits, isa, &make_float_bits, {kFloatBitsPriority});
  if (rule == Rule::net_two_layer_linear) {
    list.add(simd_fixed_point, isa, &make_fixed_point, {kFixedPointPriority});
  }
}

}  // namespace

std::vector<ThinningVariant> net_variants(Rule rule) {
  ThinningVariants list;
  list.add_with_threads(lut, Isa::baseline, &make_net_lut, {kLutPriority});
  list.add(lut_sliding, Isa::baseline, &make_net_lut_sliding, {kLutSlidingPriority});
  list.add_with_threads(bitpacked, Isa::baseline, &make_net_bitpacked, {kBitpackedPriority});
  for (const Isa isa : all_isas()) {
    add_arithmetic(list, rule, isa);
    list.add_with_threads(simd_bitpacked, isa, &make_net_simd_bitpacked, {kSimdBitpackedPriority});
    if (kernels_of<RowKernels>(isa).custom != nullptr) {
      list.add(simd_bitpacked_row, isa, &make_net_row, {kRowPriority, kRowKernelWidth});
    }
  }
  return list.take();
}

std::shared_ptr<const NetModel> default_net(Rule rule) {
  static const auto sigmoid = two_layer_net(kPaperTwoLayer, Activation::sigmoid);
  static const auto rounded = two_layer_net(kRoundedTwoLayer, Activation::sigmoid);
  static const auto linear = two_layer_net(kPaperTwoLayer, Activation::linear);
  static const auto cluster = cluster_net(kTrainedCluster);
  if (rule == Rule::net_two_layer_sigmoid) return sigmoid;
  if (rule == Rule::net_two_layer_rounded) return rounded;
  if (rule == Rule::net_two_layer_linear) return linear;
  if (rule == Rule::net_single_layer_cluster) return cluster;
  return nullptr;
}

}  // namespace thinbench::detail
