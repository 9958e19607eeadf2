#include "core/variant.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace thinbench::detail {
namespace {

std::string description(const Execution& execution, bool threaded) {
  const std::string isa =
      execution.isa ? std::string(isa_name(*execution.isa)) : "any instruction set";
  return " at " + isa + (threaded ? " with threads: " : " on one thread: ");
}

/// The ISAs of the variants, each once.
std::string isa_names(std::span<const VariantInfo> variants) {
  std::vector<Isa> isas;
  std::string text;
  for (const VariantInfo& variant : variants) {
    if (std::find(isas.begin(), isas.end(), variant.isa) != isas.end()) continue;
    text.append(isas.empty() ? "" : ", ").append(isa_name(variant.isa));
    isas.push_back(variant.isa);
  }
  return text;
}

bool use_threads(std::span<const VariantInfo> variants, Index width, Index height, int threads) {
  const bool is_small = height <= 0 || width <= (kMinPixelsForThreads - 1) / height;
  return threads > 1 && !is_small &&
         std::any_of(variants.begin(), variants.end(),
                     [](const auto& one) { return one.threaded; });
}

}  // namespace

std::string unavailable_reason(const VariantInfo& variant, Index width) {
  if (const std::string missing = missing_features(variant.isa); !missing.empty()) {
    return "this machine lacks " + missing;
  }
  if (!isa_available(variant.isa)) return "above the ISA cap";
  if (width > variant.max_width) {
    return "wider than this variant's limit of " + std::to_string(variant.max_width) + " pixels";
  }
  return {};
}

void require_available(const VariantInfo& variant, Index width) {
  const std::string reason = unavailable_reason(variant, width);
  if (reason.empty()) return;
  throw std::invalid_argument(std::string(variant.technique) + " at " +
                              std::string(isa_name(variant.isa)) + " cannot run: " + reason);
}

Isa checked_isa(const Execution& execution) {
  require_threads(execution.threads);
  if (!execution.isa) return best_isa();
  require_available({.technique = "this function", .isa = *execution.isa}, 0);
  return *execution.isa;
}

std::size_t choose_variant(std::string_view operation, std::span<const VariantInfo> variants,
                           Index width, Index height, const Execution& execution) {
  require_threads(execution.threads);
  const bool threaded = use_threads(variants, width, height, execution.threads);
  std::string reason;
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const VariantInfo& one = variants[i];
    if (one.threaded != threaded || one.isa != execution.isa.value_or(one.isa)) continue;
    if (std::string why = unavailable_reason(one, width); !why.empty()) {
      reason = std::move(why);
    } else if (!best || one.priority > variants[*best].priority) {
      best = i;
    }
  }
  if (best) return *best;
  if (reason.empty()) reason = "its instruction sets are " + isa_names(variants);
  throw std::invalid_argument(std::string(operation) + description(execution, threaded) + reason);
}

}  // namespace thinbench::detail
