#include "core/variant.hpp"

namespace thinbench::detail {
namespace {

IsaSet bit_of(Isa isa) {
  return IsaSet{1} << static_cast<int>(isa);
}

/// Found out once, as every call asks.
IsaSet available_isas() {
  static const IsaSet available = [] {
    IsaSet isas = 0;
    for (const Isa isa : all_isas()) isas |= isa_available(isa) ? bit_of(isa) : 0;
    return isas;
  }();
  return available;
}

/// Empty if this machine has the ISA and the cap contains it.
std::string unavailable_reason(Isa isa) {
  if (const std::string missing = missing_features(isa); !missing.empty()) {
    return "this machine lacks " + missing;
  }
  return isa_available(isa) ? "" : "above the ISA cap";
}

}  // namespace

std::string unavailable_reason(const VariantInfo& variant, Index width) {
  if (std::string reason = unavailable_reason(variant.isa); !reason.empty()) return reason;
  if (width <= variant.max_width) return {};
  return "wider than this variant's limit of " + std::to_string(variant.max_width) + " pixels";
}

IsaSet usable_isas(const Execution& execution) {
  require_threads(execution.threads);
  const IsaSet available = available_isas();
  if (!execution.isa) return available;
  const std::string_view name = isa_name(*execution.isa);  // throws outside the enumeration
  const IsaSet highest = bit_of(*execution.isa);
  require((available & highest) != 0, [&] {
    return "isa: " + std::string(name) + " is not available: " + unavailable_reason(*execution.isa);
  });
  return available & (highest | (highest - 1));
}

Isa checked_isa(const Execution& execution) {
  static_cast<void>(usable_isas(execution));
  return execution.isa.value_or(best_isa());
}

bool use_threads(Index width, Index height, const Execution& execution) {
  return execution.threads > 1 && height > 0 && width > (kMinPixelsForThreads - 1) / height;
}

}  // namespace thinbench::detail
