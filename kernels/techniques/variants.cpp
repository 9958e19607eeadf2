#include "techniques/variants.hpp"

#include <array>
#include <stdexcept>

#include "core/exported.hpp"
#include "distance/kernels.hpp"
#include "graph/node_pixels.hpp"
#include "techniques/autovec_edges.hpp"
#include "techniques/midpoints.hpp"
#include "techniques/thinning.hpp"

namespace thinbench::detail::study {
namespace {

constexpr std::array kTechniques = {
    TechniqueInfo{"lut", "neighbourhoods gathered from bytes, one look-up table"},
    TechniqueInfo{"lut_sliding", "neighbourhoods that slide along the row, 4096-entry table"},
    TechniqueInfo{"union_find",
                  "two-pass labelling of bytes, provisional labels in a union-find forest"},
    TechniqueInfo{"autovec", "the reference's arithmetic, vectorised by the compiler"},
    TechniqueInfo{"simd_float_bits",
                  "xsimd, the net's sums in single precision, from packed pixels"},
    TechniqueInfo{"simd_fixed_point",
                  "xsimd, the net's sums on 8-bit integers, from packed pixels"},
    TechniqueInfo{"bitpacked", "64 pixels per word, the minimal circuit"},
    TechniqueInfo{"bitpacked_runs",
                  "runs of packed pixels by count-trailing-zeros, union-find over runs"},
    TechniqueInfo{"bitpacked_contacts",
                  "runs of packed pixels and their contacts as bits, union-find where runs meet"},
    TechniqueInfo{"simd_contacts", "the same, labels painted by lane permutations"},
    TechniqueInfo{"bitpacked_flood", "background flooded from the border, 64 pixels per addition"},
    TechniqueInfo{"simd_flood", "the same with bits gathered and scattered, or 512 per addition"},
    TechniqueInfo{"simd_bytes", "xsimd, one pixel per byte lane"},
    TechniqueInfo{"simd_bitpacked", "xsimd on packed words, any width"},
    TechniqueInfo{"simd_bitpacked_tiles",
                  "xsimd on tiles of packed pixels, only where something changed"},
    TechniqueInfo{"simd_bitpacked_row", "one row of up to 512 pixels in one AVX-512 register"},
    TechniqueInfo{"simd_16bit", "gradients in 16-bit lanes, one fused scan of the image"},
    TechniqueInfo{"simd_8bit", "gradients in saturating 8-bit lanes, where these are exact"},
    TechniqueInfo{"simd_runs", "xsimd, one run per lane; union-find for runs that change"},
    TechniqueInfo{"envelope", "the lower envelope of parabolas, in time linear in the width"},
    TechniqueInfo{"simd_search", "xsimd, rows searched in 16-bit lanes, only as far as needed"},
};

/// The operation with more variants in front of its own.
template <class Operation>
Operation with(VariantList<typename Operation::StateType> list, Operation operation) {
  auto variants = list.take();
  variants.insert(variants.end(), operation.variants.begin(), operation.variants.end());
  operation.variants = std::move(variants);
  return operation;
}

/// All operations of a family, with the techniques that `techniques_of(operation)` adds.
template <class Operation, class TechniquesOf>
std::vector<Operation> extended(std::span<const Operation> operations,
                                const TechniquesOf& techniques_of) {
  std::vector<Operation> all;
  for (const Operation& operation : operations) {
    all.push_back(with(techniques_of(operation), operation));
  }
  return all;
}

std::unique_ptr<EdgeState> make_autovec_edges(const EdgeSetting& setting) {
  const AutovecEdgeKernels& kernels = kernels_of<AutovecEdgeKernels>(setting.isa);
  return std::make_unique<EdgeState>(kernels.bytes[setting.op], setting);
}

EdgeVariants edge_techniques() {
  EdgeVariants list;
  for (const Isa isa : isas_of<AutovecEdgeKernels>()) {
    list.add("autovec", isa, &make_autovec_edges, {0});
  }
  return list;
}

std::unique_ptr<DistanceState> make_envelope(const DistanceSetting& setting) {
  DistanceKernels kernels = kernels_of<DistanceKernels>(setting.isa);
  kernels.row = &envelope_row;
  return std::make_unique<DistanceState>(kernels, setting);
}

std::unique_ptr<GraphState> make_bitpacked_graph(const GraphSetting& setting) {
  return std::make_unique<GraphState>(kBitpackedGraph, setting);
}

}  // namespace

std::span<const ThinningOperation> thinning_operations() {
  static const auto all = [] {
    auto operations = extended(detail::thinning_operations(), [](const auto& operation) {
      return thinning_techniques(*body_of(operation.key));
    });
    for (const StudyRuleInfo& info : kStudyRules) {
      const Rule rule = make_rule(info.rule);
      operations.push_back({rule, info.operation, info.description, all_variants(*body_of(rule))});
    }
    return operations;
  }();
  return all;
}

std::span<const EdgeOperation> edge_operations() {
  static const auto all =
      extended(detail::edge_operations(), [](const auto&) { return edge_techniques(); });
  return all;
}

const DistanceOperation& distance_operation() {
  static const DistanceOperation operation = [] {
    VariantList<DistanceState> list;
    list.add_with_threads("envelope", Isa::baseline, &make_envelope, {0});
    return with(std::move(list), detail::distance_operation());
  }();
  return operation;
}

const GraphOperation& graph_operation() {
  static const GraphOperation operation = [] {
    VariantList<GraphState> list;
    list.add_with_threads("bitpacked", Isa::baseline, &make_bitpacked_graph, {0});
    return with(std::move(list), detail::graph_operation());
  }();
  return operation;
}

const MidpointOperation& midpoint_operation() {
  static const MidpointOperation operation =
      with(midpoint_techniques(), detail::midpoint_operation());
  return operation;
}

const ThinningOperation& operation_of(BuiltInRule rule) {
  static_cast<void>(rule_info(rule));
  return thinning_operations()[static_cast<std::size_t>(rule)];
}

const ThinningOperation& operation_of(StudyRule rule) {
  return thinning_operations()[kRules.size() + static_cast<std::size_t>(rule)];
}

std::vector<ThinningVariant> all_variants(const RuleBody& rule) {
  auto variants = thinning_techniques(rule).take();
  if (dynamic_cast<const SptaBody*>(&rule) != nullptr) return variants;
  const auto& product = detail::thinning_variants(rule);
  variants.insert(variants.end(), product.begin(), product.end());
  return variants;
}

const TechniqueInfo& technique_info(std::string_view name) {
  for (const TechniqueInfo& info : kTechniques) {
    if (info.name == name) return info;
  }
  throw std::logic_error("no technique is called " + std::string(name));
}

}  // namespace thinbench::detail::study
