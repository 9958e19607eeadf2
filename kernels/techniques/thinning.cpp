#include "techniques/thinning.hpp"

#include "core/exported.hpp"
#include "engines/variants.hpp"
#include "techniques/pass_state.hpp"
#include "techniques/study_rules.hpp"

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

const NetModel& net_of(const ThinningSetting& setting) {
  return static_cast<const study::NetBody&>(*setting.rule).model;
}

State make_float_bits(const ThinningSetting& setting) {
  const auto kind = static_cast<std::size_t>(net_of(setting).kind);
  return std::make_unique<NetState>(kernels_of<NetPasses>(setting.isa).float_bits[kind],
                                    net_of(setting), setting);
}

State make_fixed_point(const ThinningSetting& setting) {
  require(net_of(setting).fixed_point_is_exact,
          "simd_fixed_point cannot run: no 8-bit weights reproduce the decisions of this net");
  return std::make_unique<NetState>(kernels_of<NetPasses>(setting.isa).fixed_point, net_of(setting),
                                    setting);
}

void add_net(const study::NetBody& net, ThinningVariants& list) {
  if (net.circuits) {
    list.add_with_threads("lut", Isa::baseline, &make_lut, {kLut});
    list.add("lut_sliding", Isa::baseline, &make_lut_sliding, {kLutSliding});
  }
  list.add_with_threads("bitpacked", Isa::baseline, &make_bitpacked, {kBitpacked});
  for (const Isa isa : isas_of<NetPasses>()) {
    list.add_with_threads("simd_float_bits", isa, &make_float_bits, {kFloatBits});
    if (net.model.kind == NetKind::linear) {
      list.add("simd_fixed_point", isa, &make_fixed_point, {kFixedPoint});
    }
    if (net.circuits) list.add_with_threads("simd_bitpacked", isa, &make_simd_words, {kSimdWords});
  }
}

void add_built_in(BuiltInRule rule, ThinningVariants& list) {
  if (!LutPasses::kLut[rule].empty()) {
    list.add_with_threads("lut", Isa::baseline, &make_lut, {kLut});
    list.add("lut_sliding", Isa::baseline, &make_lut_sliding, {kLutSliding});
  }
  list.add_with_threads("bitpacked", Isa::baseline, &make_bitpacked, {kBitpacked});
  for (const Isa isa : isas_of<SimdPasses>()) {
    list.add("autovec", isa, &make_autovec, {kAutovec});
    list.add("simd_bytes", isa, &make_bytes, {kBytes});
    list.add_with_threads("simd_bitpacked", isa, &make_simd_words, {kSimdWords});
  }
}

}  // namespace

ThinningVariants thinning_techniques(const RuleBody& rule) {
  ThinningVariants list;
  if (const auto* net = dynamic_cast<const study::NetBody*>(&rule)) {
    add_net(*net, list);
  } else if (dynamic_cast<const study::SptaBody*>(&rule) != nullptr) {
    list.add("bitpacked", Isa::baseline, &make_spta, {kBitpacked});
  } else if (rule.circuits) {
    add_built_in(*rule.circuits, list);
  } else {
    list.add_with_threads("bitpacked", Isa::baseline, &make_bitpacked, {kBitpacked});
  }
  return list;
}

}  // namespace thinbench::detail
