#include "dispatch/variant_choice.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "image/checks.hpp"

namespace thinbench {
namespace {

bool fits(const VariantFacts& variant, const VariantRequest& wish) {
  if (wish.technique && *wish.technique != variant.technique) return false;
  if (wish.isa && *wish.isa != variant.isa) return false;
  return variant.threaded == (wish.threads > 1);
}

/// The list of techniques ends with the fastest.
bool is_faster(const VariantFacts& a, const VariantFacts& b) {
  return a.isa != b.isa ? a.isa > b.isa : a.technique > b.technique;
}

std::string description(const VariantRequest& wish) {
  std::string text =
      wish.technique ? std::string(technique_name(*wish.technique)) : "any technique";
  text += " at ";
  text += wish.isa ? std::string(isa_name(*wish.isa)) : "any instruction set";
  return text + (wish.threads > 1 ? " with threads" : " on one thread");
}

/// Names in the order of the variants, each once.
template <class Keep, class NameOf>
std::string names_of(std::span<const VariantFacts> variants, const Keep& keep,
                     const NameOf& name_of) {
  std::vector<std::string_view> names;
  std::string text;
  for (const VariantFacts& variant : variants) {
    const std::string_view name = name_of(variant);
    if (!keep(variant) || std::find(names.begin(), names.end(), name) != names.end()) continue;
    text.append(names.empty() ? "" : ", ").append(name);
    names.push_back(name);
  }
  return text;
}

/// Why no variant is as wished, whatever the machine and the image: the first of technique, level
/// and threads that does not fit.
std::string available_options(std::span<const VariantFacts> variants, const VariantRequest& wish) {
  const auto has_technique = [&](const VariantFacts& one) {
    return one.technique == wish.technique.value_or(one.technique);
  };
  if (std::none_of(variants.begin(), variants.end(), has_technique)) {
    const auto name_of = [](const VariantFacts& one) { return technique_name(one.technique); };
    return "its techniques are " + names_of(
                                       variants, [](const auto&) { return true; }, name_of);
  }
  const auto has_level = [&](const VariantFacts& one) {
    return has_technique(one) && one.isa == wish.isa.value_or(one.isa);
  };
  if (std::none_of(variants.begin(), variants.end(), has_level)) {
    const auto name_of = [](const VariantFacts& one) { return isa_name(one.isa); };
    return "its instruction sets are " + names_of(variants, has_technique, name_of);
  }
  return "it runs on one thread only";
}

}  // namespace

std::string_view unavailable_reason(const VariantFacts& variant, Index width) {
  if (!cpu_supports(variant.isa)) return "this machine lacks the instruction set";
  if (!isa_available(variant.isa)) return "above the ISA cap";
  if (width > variant.max_width) return "wider than this variant's limit";
  return {};
}

std::string obstacle(const VariantFacts& variant, Index width) {
  std::string text(unavailable_reason(variant, width));
  const bool is_too_wide = isa_available(variant.isa) && width > variant.max_width;
  if (is_too_wide) text += " of " + std::to_string(variant.max_width) + " pixels";
  return text;
}

std::size_t choose_variant(std::string_view operation, std::span<const VariantFacts> variants,
                           Index width, const VariantRequest& wish) {
  require_threads(wish.threads);
  std::string reason;
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    if (!fits(variants[i], wish)) continue;
    if (std::string why = obstacle(variants[i], width); !why.empty()) {
      reason = std::move(why);
    } else if (!best || is_faster(variants[i], variants[*best])) {
      best = i;
    }
  }
  if (!best && reason.empty()) {
    reason = "there is no such variant; " + available_options(variants, wish);
  }
  require(best.has_value(), std::string(operation) + " by " + description(wish) + ": " + reason);
  return *best;
}

}  // namespace thinbench
