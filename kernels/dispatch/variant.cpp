#include "dispatch/variant.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace thinbench::detail {
namespace {

bool fits(const VariantInfo& variant, const Options& options) {
  if (options.technique && *options.technique != variant.technique) return false;
  if (options.isa && *options.isa != variant.isa) return false;
  return variant.threaded == (options.threads > 1);
}

std::string description(const Options& options) {
  std::string text =
      options.technique ? std::string(technique_name(*options.technique)) : "any technique";
  text += " at ";
  text += options.isa ? std::string(isa_name(*options.isa)) : "any instruction set";
  return text + (options.threads > 1 ? " with threads" : " on one thread");
}

/// Names in the order of the variants, each once.
template <class Keep, class NameOf>
std::string names_of(std::span<const VariantInfo> variants, const Keep& keep,
                     const NameOf& name_of) {
  std::vector<std::string_view> names;
  std::string text;
  for (const VariantInfo& variant : variants) {
    const std::string_view name = name_of(variant);
    if (!keep(variant) || std::find(names.begin(), names.end(), name) != names.end()) continue;
    text.append(names.empty() ? "" : ", ").append(name);
    names.push_back(name);
  }
  return text;
}

/// For options that no variant has: the values available for the first of technique, ISA and
/// threads that does not fit.
std::string available_options(std::span<const VariantInfo> variants, const Options& options) {
  const auto has_technique = [&](const VariantInfo& one) {
    return one.technique == options.technique.value_or(one.technique);
  };
  if (std::none_of(variants.begin(), variants.end(), has_technique)) {
    const auto name_of = [](const VariantInfo& one) { return technique_name(one.technique); };
    return "its techniques are " + names_of(
                                       variants, [](const auto&) { return true; }, name_of);
  }
  const auto has_isa = [&](const VariantInfo& one) {
    return has_technique(one) && one.isa == options.isa.value_or(one.isa);
  };
  if (std::none_of(variants.begin(), variants.end(), has_isa)) {
    const auto name_of = [](const VariantInfo& one) { return isa_name(one.isa); };
    return "its instruction sets are " + names_of(variants, has_technique, name_of);
  }
  return "it runs on one thread only";
}

}  // namespace

std::string unavailable_reason(const VariantInfo& variant, Index width, Border border) {
  if (const std::string missing = missing_features(variant.isa); !missing.empty()) {
    return "this machine lacks " + missing;
  }
  if (!isa_available(variant.isa)) return "above the ISA cap";
  if (width > variant.max_width) {
    return "wider than this variant's limit of " + std::to_string(variant.max_width) + " pixels";
  }
  if (border == Border::keep && !variant.keeps_border) return "it does not keep the border";
  return {};
}

std::size_t choose_variant(std::string_view operation, std::span<const VariantInfo> variants,
                           Index width, const Options& options) {
  // Rejects values outside the enumeration; isa_name does so for ISAs.
  if (options.technique) static_cast<void>(technique_info(*options.technique));
  std::string reason;
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    if (!fits(variants[i], options)) continue;
    if (std::string why = unavailable_reason(variants[i], width, options.border); !why.empty()) {
      reason = std::move(why);
    } else if (!best || variants[i].priority > variants[*best].priority) {
      best = i;
    }
  }
  if (best) return *best;
  if (reason.empty()) reason = "there is no such variant; " + available_options(variants, options);
  throw std::invalid_argument(std::string(operation) + " by " + description(options) + ": " +
                              reason);
}

}  // namespace thinbench::detail
