#include "core/variant_choice.hpp"

#include <stdexcept>
#include <string>

namespace thinbench {
namespace {

bool fits(const VariantFacts& variant, const VariantWish& wish) {
  if (wish.technique && *wish.technique != variant.technique) return false;
  if (wish.isa && *wish.isa != variant.isa) return false;
  return variant.threaded == (wish.threads > 1);
}

/// The list of techniques ends with the fastest.
bool is_faster(const VariantFacts& a, const VariantFacts& b) {
  return a.isa != b.isa ? a.isa > b.isa : a.technique > b.technique;
}

std::string description(const VariantWish& wish) {
  std::string text =
      wish.technique ? std::string(technique_name(*wish.technique)) : "any technique";
  text += " at ";
  text += wish.isa ? std::string(isa_name(*wish.isa)) : "any instruction set";
  return text + (wish.threads > 1 ? " with threads" : " on one thread");
}

}  // namespace

std::string_view why_unavailable(const VariantFacts& variant, Index width) {
  if (!cpu_supports(variant.isa)) return "this machine lacks the instruction set";
  if (!isa_available(variant.isa)) return "above the ISA cap";
  if (width > variant.max_width) return "wider than this variant's limit";
  return {};
}

std::size_t choose_variant(std::string_view operation, std::span<const VariantFacts> variants,
                           Index width, const VariantWish& wish) {
  if (wish.threads < 1 || wish.threads > kMostThreads) {
    throw std::invalid_argument("threads is " + std::to_string(wish.threads) +
                                "; it must be in 1..1024");
  }
  std::string_view reason = "there is no such variant";
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    if (!fits(variants[i], wish)) continue;
    const std::string_view why = why_unavailable(variants[i], width);
    if (!why.empty()) {
      reason = why;
    } else if (!best || is_faster(variants[i], variants[*best])) {
      best = i;
    }
  }
  if (best) return *best;
  throw std::invalid_argument(std::string(operation) + " by " + description(wish) + ": " +
                              std::string(reason));
}

}  // namespace thinbench
