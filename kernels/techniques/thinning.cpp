#include "techniques/thinning.hpp"

#include "core/exported.hpp"
#include "engines/variants.hpp"
#include "midpoints/border.hpp"
#include "midpoints/variants.hpp"
#include "techniques/midpoints.hpp"
#include "techniques/net_kernels.hpp"
#include "techniques/pass_state.hpp"

namespace thinbench::detail {
namespace {

using State = std::unique_ptr<ThinningState>;

/// Priorities within an ISA, below those of the product.
enum Priority : int {
  kLut,
  kLutSliding,
  kAutovec,
  kFloatBits,
  kFixedPoint,
  kBitpacked,
  kBytes,
  kSimdWords,
};

template <class T>
State make_passes(const PassesByRule<T>& passes, const ThinningSetting& setting) {
  return std::make_unique<PassState<T>>(passes[setting.rule->circuits.value()].functions(),
                                        setting);
}

State make_lut(const ThinningSetting& setting) {
  return make_passes(LutPasses::kLut, setting);
}
State make_lut_sliding(const ThinningSetting& setting) {
  return make_passes(LutPasses::kLutSliding, setting);
}
State make_autovec(const ThinningSetting& setting) {
  return make_passes(kernels_of<AutovecPasses>(setting.isa).bytes, setting);
}
State make_bytes(const ThinningSetting& setting) {
  return make_passes(kernels_of<SimdPasses>(setting.isa).bytes, setting);
}
State make_simd_words(const ThinningSetting& setting) {
  return make_passes(kernels_of<SimdPasses>(setting.isa).words, setting);
}

/// Words of 64 pixels in general registers: circuits, or for tables the interpreter.
State make_bitpacked(const ThinningSetting& setting) {
  if (setting.rule->circuits) return make_passes(kScalarPasses, setting);
  BoundRule rule = setting.rule->compiled->bind_interpreter(kScalarInterpreter, false, 1);
  rule.owner = setting.rule;
  return make_words(std::move(rule), setting);
}

// Nets. Their table is enough for the techniques of look-up tables; the others do the arithmetic.

std::shared_ptr<const NetModel> model_of(const RuleBody& rule) {
  const WindowTable& table = rule.compiled->tables().front();
  if (const auto* net = std::get_if<TwoLayerNet>(&rule.net)) {
    return std::make_shared<NetModel>(make_net_model(net->weights, net->activation, table));
  }
  return std::make_shared<NetModel>(make_net_model(std::get<ClusterWeights>(rule.net), table));
}

State make_net_pass(const BytePass& pass, const ThinningSetting& setting) {
  return std::make_unique<PassState<std::uint8_t>>(std::span(&pass, 1), setting,
                                                   model_of(*setting.rule));
}

State make_net_lut(const ThinningSetting& setting) {
  return make_net_pass(LutPasses::kTableLut, setting);
}
State make_net_lut_sliding(const ThinningSetting& setting) {
  return make_net_pass(LutPasses::kTableLutSliding, setting);
}

bool is_linear(const RuleBody& rule) {
  const auto* net = std::get_if<TwoLayerNet>(&rule.net);
  return net != nullptr && net->activation == Activation::linear;
}

template <class AnyPass>
const AnyPass& pass_of(const NetPasses<AnyPass>& passes, const RuleBody& rule) {
  if (std::holds_alternative<ClusterWeights>(rule.net)) return passes.cluster;
  return is_linear(rule) ? passes.linear : passes.sigmoid;
}

State make_net_autovec(const ThinningSetting& setting) {
  return make_net_pass(pass_of(kernels_of<AutovecNetKernels>(setting.isa).bytes, *setting.rule),
                       setting);
}

State make_float_bits(const ThinningSetting& setting) {
  return std::make_unique<ChangeState>(
      pass_of(kernels_of<FloatNetKernels>(setting.isa).bits, *setting.rule), setting,
      model_of(*setting.rule));
}

State make_fixed_point(const ThinningSetting& setting) {
  auto model = model_of(*setting.rule);
  require(model->fixed_point_is_exact,
          "simd_fixed_point cannot run: no 8-bit weights reproduce the decisions of this net");
  return std::make_unique<ChangeState>(kernels_of<FixedPointKernels>(setting.isa).linear, setting,
                                       std::move(model));
}

void add_nets(const RuleBody& rule, ThinningVariants& list) {
  list.add_with_threads("lut", Isa::baseline, &make_net_lut, {kLut});
  list.add("lut_sliding", Isa::baseline, &make_net_lut_sliding, {kLutSliding});
  list.add_with_threads("bitpacked", Isa::baseline, &make_bitpacked, {kBitpacked});
  for (const Isa isa : all_isas()) {
    if (kernels_of<AutovecNetKernels>(isa).bytes.sigmoid != nullptr) {
      list.add("autovec", isa, &make_net_autovec, {kAutovec});
    }
    list.add_with_threads("simd_float_bits", isa, &make_float_bits, {kFloatBits});
    if (is_linear(rule)) list.add("simd_fixed_point", isa, &make_fixed_point, {kFixedPoint});
    if (rule.circuits) {
      list.add_with_threads("simd_bitpacked", isa, &make_simd_words, {kSimdWords});
    }
  }
}

void add_built_in(BuiltInRule rule, ThinningVariants& list) {
  if (!LutPasses::kLut[rule].empty()) {
    list.add_with_threads("lut", Isa::baseline, &make_lut, {kLut});
    list.add("lut_sliding", Isa::baseline, &make_lut_sliding, {kLutSliding});
  }
  list.add_with_threads("bitpacked", Isa::baseline, &make_bitpacked, {kBitpacked});
  for (const Isa isa : all_isas()) {
    list.add("autovec", isa, &make_autovec, {kAutovec});
    list.add("simd_bytes", isa, &make_bytes, {kBytes});
    list.add_with_threads("simd_bitpacked", isa, &make_simd_words, {kSimdWords});
  }
}

// The midpoint scan.

/// The scan on bytes.
class ByteScanState final : public PlaneState<std::uint8_t> {
 public:
  explicit ByteScanState(const ThinningSetting& setting)
      : PlaneState(setting),
        kernels_(kernels_of<ByteScanKernels>(setting.isa)),
        directions_(setting.rule->directions),
        border_(setting.border),
        scratch_(make_aligned<std::uint64_t>(
            static_cast<std::size_t>(kernels_.scratch_words(setting.width, setting.height)))) {}

  int compute() override {
    kernels_.run(directions_, source(), planes.result.view(), scratch_.get());
    apply_border(border_, source(), planes.result.view());
    return 1;
  }

 private:
  const ByteScanKernels& kernels_;
  Directions directions_;
  Border border_;
  AlignedArray<std::uint64_t> scratch_;
};

State make_byte_scan(const ThinningSetting& setting) {
  return std::make_unique<ByteScanState>(setting);
}

State make_bitpacked_scan(const ThinningSetting& setting) {
  return make_midpoint_scan(kBitpackedScan, setting);
}

void add_midpoint_scan(ThinningVariants& list) {
  list.add_with_threads("bitpacked", Isa::baseline, &make_bitpacked_scan, {1});
  for (const Isa isa : all_isas()) list.add("autovec", isa, &make_byte_scan, {0});
}

}  // namespace

ThinningVariants thinning_techniques(const RuleBody& rule) {
  ThinningVariants list;
  if (rule.kind == RuleKind::midpoints) {
    add_midpoint_scan(list);
  } else if (!std::holds_alternative<std::monostate>(rule.net)) {
    add_nets(rule, list);
  } else if (rule.circuits) {
    add_built_in(*rule.circuits, list);
  } else if (rule.kind == RuleKind::parallel) {
    list.add_with_threads("bitpacked", Isa::baseline, &make_bitpacked, {kBitpacked});
  }
  return list;
}

}  // namespace thinbench::detail
