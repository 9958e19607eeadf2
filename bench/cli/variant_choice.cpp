#include "cli/variant_choice.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "cli/command.hpp"
#include "cli/names.hpp"

namespace thinbench {
namespace {

using Variants = std::vector<const VariantFacts*>;

/// What is chosen from, and the name by which it is refused.
struct Choice {
  std::string operation;
  std::span<const VariantFacts> variants;
};

template <class Condition>
Variants variants_where(const Choice& choice, const Condition& condition) {
  Variants found;
  for (const VariantFacts& variant : choice.variants) {
    if (condition(variant)) found.push_back(&variant);
  }
  return found;
}

/// "a, b and c", each once, in the order of the variants.
template <class NameOf>
std::string names_of(const Variants& variants, const NameOf& name_of) {
  std::vector<std::string_view> names;
  for (const VariantFacts* variant : variants) {
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
Variants of_technique(const Choice& choice, std::optional<Technique> technique) {
  const auto name_of = [](const VariantFacts& one) { return technique_name(one.technique); };
  Variants found = variants_where(choice, [&](const VariantFacts& variant) {
    return variant.technique == technique.value_or(variant.technique);
  });
  if (!found.empty()) return found;
  const Variants all = variants_where(choice, [](const VariantFacts&) { return true; });
  throw UsageError(choice.operation + " is not made by " + std::string(technique_name(*technique)) +
                   ", only by " + names_of(all, name_of));
}

/// The variants of the wanted kind, wherever they run. `subject` begins the refusals.
Variants wanted_variants(const std::string& subject, const Variants& candidates,
                         const Options& wish) {
  Variants wanted;
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(wanted),
               [&](const VariantFacts* one) { return one->isa == wish.isa.value_or(one->isa); });
  if (wanted.empty()) {
    const auto name_of = [](const VariantFacts& one) { return isa_name(one.isa); };
    throw UsageError(subject + " is not made for " + std::string(isa_name(*wish.isa)) +
                     ", only for " + names_of(candidates, name_of));
  }
  std::erase_if(wanted,
                [&](const VariantFacts* one) { return one->threaded != (wish.threads > 1); });
  if (!wanted.empty()) return wanted;
  throw UsageError(subject + " runs on one thread only, not on " + std::to_string(wish.threads));
}

std::size_t place_for(const Choice& choice, Index width, const Options& wish) {
  if (wish.isa) check_isa(*wish.isa);
  const std::string subject(wish.technique ? std::string(technique_name(*wish.technique))
                                           : choice.operation);
  const Variants wanted = wanted_variants(subject, of_technique(choice, wish.technique), wish);
  const auto fits = [&](const VariantFacts* one) { return unavailable_reason(*one, width).empty(); };
  if (std::any_of(wanted.begin(), wanted.end(), fits)) {
    return choose_variant(choice.operation, choice.variants, width, wish);
  }
  const VariantFacts& first = *wanted.front();  // the lowest level
  check_isa(first.isa);
  throw std::runtime_error(std::string(technique_name(first.technique)) + " takes pictures up to " +
                           std::to_string(first.max_width) + " pixels wide; this one has " +
                           std::to_string(width));
}

std::vector<const ThinningVariant*> with_border(const ThinningOperation& operation, Border border) {
  try {
    return variants_for_border(operation, border);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--border: ") + error.what());
  }
}

}  // namespace

const ThinningVariant& variant_for(const ThinningOperation& operation, Index width,
                                   const Options& options) {
  const Border border = options.border.value_or(operation.border);
  const std::vector<const ThinningVariant*> candidates = with_border(operation, border);
  std::vector<VariantFacts> facts;
  for (const ThinningVariant* one : candidates) facts.push_back(facts_of(*one));
  const std::string kept = border == Border::keep ? " with the border kept" : "";
  const Options wish = {options.technique, options.isa, options.threads};
  return *candidates[place_for({std::string(operation.name) + kept, facts}, width, wish)];
}

const EdgeVariant& variant_for(const EdgeOperation& operation, Index width,
                               const Options& wish) {
  std::vector<VariantFacts> facts;
  for (const EdgeVariant& one : operation.variants) facts.push_back(one.facts);
  return operation.variants[place_for({std::string(operation.name), facts}, width, wish)];
}

const HolesVariant& variant_for(const HolesOperation& operation, Index width,
                                const Options& wish) {
  std::vector<VariantFacts> facts;
  for (const HolesVariant& one : operation.variants) facts.push_back(facts_of(one));
  return operation.variants[place_for({std::string(operation.name), facts}, width, wish)];
}

}  // namespace thinbench
