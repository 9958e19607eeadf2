#include "localise/plan.hpp"

#include <algorithm>
#include <stdexcept>

#include "catalog.hpp"
#include "regions/plan.hpp"

namespace thinbench::detail {
namespace {

/// The operator's variant that writes bits, at this level or the highest below that it has.
EdgePlan edge_plan(const VariantFacts& facts, Index width, Index height,
                   const LocaliseOptions& options) {
  const auto operations = edge_operations();
  const auto operation = std::find_if(operations.begin(), operations.end(),
                                      [&](const auto& one) { return one.op == options.edges; });
  if (operation == operations.end()) throw std::invalid_argument("there is no such edge operator");
  const EdgeVariant* best = nullptr;
  for (const EdgeVariant& variant : operation->variants) {
    const bool fits = variant.writes_bits() && variant.facts.threaded == facts.threaded;
    if (fits && variant.facts.isa <= facts.isa) best = &variant;
  }
  if (best == nullptr) throw std::logic_error("no variant of this operator writes bits here");
  return {*operation, *best, width, height, {options.thresholds, options.threads}};
}

const RunEngine& run_engine(const VariantFacts& facts) {
  return facts.technique == Technique::simd_runs ? simd_run_engine(facts.isa) : kBitpackedRunEngine;
}

const VariantFacts& checked(const VariantFacts& facts, Index width, Index height, int threads) {
  check_regions_plan(facts, width, height, threads);
  return facts;
}

}  // namespace

LocalisePlan::LocalisePlan(const LocaliseVariant& variant, Index width, Index height,
                           const LocaliseOptions& options)
    : edges_(edge_plan(checked(variant.facts, width, height, options.threads), width, height,
                       options)),
      outlined_(width, height),
      objects_(width, height),
      regions_(run_engine(variant.facts).holes, width, height,
               variant.facts.threaded ? options.threads : 1) {}

RegionLists LocalisePlan::run(const ConstImageView& source) {
  outlined_.write(edges_.run_to_bits(source), objects_.view());
  return regions_.label(objects_.view());
}

bool LocalisePlan::margins_are_zero() const {
  return edges_.margins_are_zero() && objects_.margin_is_zero();
}

}  // namespace thinbench::detail
