#include "sweeps/variants.hpp"

#include <functional>

namespace thinbench {
namespace {

const Variant* best(const Operation& operation, Index width,
                    const std::function<bool(const Variant&)>& is_wanted) {
  const Variant* found = nullptr;
  for (const Variant& variant : operation.variants) {
    if (variant.is_peer || !is_wanted(variant) || !variant.unavailable_reason(width).empty())
      continue;
    if (found == nullptr || variant.priority > found->priority) found = &variant;
  }
  return found;
}

}  // namespace

const Variant* chosen_variant(const Operation& operation, Index width, bool threaded, Isa cap) {
  return best(operation, width, [&](const Variant& variant) {
    return variant.threaded == threaded && variant.isa <= cap;
  });
}

const Variant* scalar_variant(const Operation& operation, Index width) {
  return best(operation, width, [](const Variant& variant) {
    return !variant.threaded && variant.isa == Isa::baseline &&
           !variant.technique.starts_with("simd") && variant.technique != "autovec";
  });
}

const Variant* on_one_thread(const Operation& operation, const Variant& threaded) {
  for (const Variant& variant : operation.variants) {
    const bool same = variant.technique == threaded.technique && variant.isa == threaded.isa;
    if (same && !variant.threaded) return &variant;
  }
  return nullptr;
}

}  // namespace thinbench
