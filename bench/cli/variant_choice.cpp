#include "cli/variant_choice.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "cli/command.hpp"
#include "cli/names.hpp"

namespace thinbench {
namespace {

using Variants = std::vector<const ThinningVariant*>;

template <class Condition>
Variants variants_where(const ThinningOperation& operation, const Condition& condition) {
  Variants found;
  for (const ThinningVariant& variant : operation.variants) {
    if (condition(variant)) found.push_back(&variant);
  }
  return found;
}

std::string isas_of(const ThinningOperation& operation, Technique technique) {
  std::vector<std::string_view> names;
  for (const ThinningVariant& variant : operation.variants) {
    const std::string_view name = isa_name(variant.isa);
    const bool is_new = std::find(names.begin(), names.end(), name) == names.end();
    if (variant.technique == technique && is_new) names.push_back(name);
  }
  return enumeration(names);
}

/// Why `isa` is out of reach; empty where it is not.
std::string why_out_of_reach(Isa isa) {
  const std::string name(isa_name(isa));
  const std::string best = "; the highest level here is " + std::string(isa_name(best_isa()));
  if (!cpu_supports(isa)) return "this machine lacks " + name + best;
  if (isa_available(isa)) return {};
  return name + " is above the cap " + kIsaCapVariable + "=" + std::string(isa_name(isa_cap()));
}

void check_isa(Isa isa) {
  const std::string reason = why_out_of_reach(isa);
  if (!reason.empty()) throw std::runtime_error(reason);
}

/// The variants of the wanted kind, wherever they run.
Variants wanted_variants(const ThinningOperation& operation, const ThinningOptions& options) {
  const Variants of_kind = variants_where(operation, [&](const ThinningVariant& variant) {
    return variant.technique == options.technique.value_or(variant.technique) &&
           variant.isa == options.isa.value_or(variant.isa);
  });
  if (of_kind.empty()) {
    const Technique technique = options.technique.value();
    throw UsageError(std::string(technique_name(technique)) + " is not made for " +
                     std::string(isa_name(options.isa.value())) + ", only for " +
                     isas_of(operation, technique));
  }
  Variants wanted;
  std::copy_if(of_kind.begin(), of_kind.end(), std::back_inserter(wanted),
               [&](const ThinningVariant* one) { return one->threaded == (options.threads > 1); });
  if (!wanted.empty()) return wanted;
  throw UsageError(std::string(technique_name(of_kind.front()->technique)) +
                   " runs on one thread only, not on " + std::to_string(options.threads));
}

}  // namespace

const ThinningVariant& variant_for(const ThinningOperation& operation, Index width,
                                   const ThinningOptions& options) {
  if (options.isa) check_isa(*options.isa);
  const Variants wanted = wanted_variants(operation, options);
  const auto fits = [&](const ThinningVariant* one) {
    return why_unavailable(*one, width).empty();
  };
  if (std::any_of(wanted.begin(), wanted.end(), fits)) {
    return choose_variant(operation, width, options);
  }
  const ThinningVariant& first = *wanted.front();  // the lowest level
  check_isa(first.isa);
  throw std::runtime_error(std::string(technique_name(first.technique)) + " takes pictures up to " +
                           std::to_string(first.max_width) + " pixels wide; this one has " +
                           std::to_string(width));
}

}  // namespace thinbench
