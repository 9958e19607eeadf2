#include "cli/variant_choice.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
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

/// "a, b and c", each once, in the order of the variants.
template <class NameOf>
std::string names_of(const Variants& variants, const NameOf& name_of) {
  std::vector<std::string_view> names;
  for (const ThinningVariant* variant : variants) {
    const std::string_view name = name_of(*variant);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
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

/// The variants of the wanted technique, or all.
Variants of_technique(const ThinningOperation& operation, std::optional<Technique> technique) {
  const auto name_of = [](const ThinningVariant& one) { return technique_name(one.technique); };
  Variants found = variants_where(operation, [&](const ThinningVariant& variant) {
    return variant.technique == technique.value_or(variant.technique);
  });
  if (!found.empty()) return found;
  const Variants all = variants_where(operation, [](const ThinningVariant&) { return true; });
  throw UsageError(std::string(operation.name) + " is not made by " +
                   std::string(technique_name(*technique)) + ", only by " + names_of(all, name_of));
}

/// The variants of the wanted kind, wherever they run. `subject` begins the refusals.
Variants wanted_variants(const std::string& subject, const Variants& candidates,
                         const ThinningOptions& options) {
  Variants wanted;
  std::copy_if(
      candidates.begin(), candidates.end(), std::back_inserter(wanted),
      [&](const ThinningVariant* one) { return one->isa == options.isa.value_or(one->isa); });
  if (wanted.empty()) {
    const auto name_of = [](const ThinningVariant& one) { return isa_name(one.isa); };
    throw UsageError(subject + " is not made for " + std::string(isa_name(*options.isa)) +
                     ", only for " + names_of(candidates, name_of));
  }
  std::erase_if(wanted,
                [&](const ThinningVariant* one) { return one->threaded != (options.threads > 1); });
  if (!wanted.empty()) return wanted;
  throw UsageError(subject + " runs on one thread only, not on " + std::to_string(options.threads));
}

}  // namespace

const ThinningVariant& variant_for(const ThinningOperation& operation, Index width,
                                   const ThinningOptions& options) {
  if (options.isa) check_isa(*options.isa);
  const std::string subject(options.technique ? technique_name(*options.technique)
                                              : operation.name);
  const Variants wanted =
      wanted_variants(subject, of_technique(operation, options.technique), options);
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
