// Variants: the ways in which an operation can be computed, one type for all families, and the
// choice among them.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"

namespace thinbench::detail {

inline constexpr Index kAnyWidth = std::numeric_limits<Index>::max();
/// Of these, the one with the higher priority is taken where both can run.
inline constexpr int kPrioritiesPerIsa = 100;

/// What a choice depends on.
struct VariantInfo {
  Technique technique;
  Isa isa;
  bool threaded = false;        // shares the work among the threads asked for
  Index max_width = kAnyWidth;  // wider images need another variant
  bool keeps_border = true;     // can compute with Border::keep
  int priority = 0;
};

/// A variant of a family whose states are made from a `State::Setting`.
template <class State>
struct Variant : VariantInfo {
  std::unique_ptr<State> (*make)(const typename State::Setting& setting) = nullptr;
};

/// Builds the list of variants of one operation.
template <class State>
class VariantList {
 public:
  using Make = std::unique_ptr<State> (*)(const typename State::Setting& setting);

  /// What `priority` is within its ISA; any variant of a later ISA comes before all of an earlier.
  struct Facts {
    int priority = 0;
    Index max_width = kAnyWidth;
    bool keeps_border = true;
  };

  void add(Technique technique, Isa isa, Make make, const Facts& facts, bool threaded = false) {
    const int priority = static_cast<int>(isa) * kPrioritiesPerIsa + facts.priority;
    variants_.push_back(
        {{technique, isa, threaded, facts.max_width, facts.keeps_border, priority}, make});
  }

  /// For one thread and for several.
  void add_with_threads(Technique technique, Isa isa, Make make, const Facts& facts) {
    add(technique, isa, make, facts);
    add(technique, isa, make, facts, true);
  }

  [[nodiscard]] std::vector<Variant<State>> take() { return std::move(variants_); }

 private:
  std::vector<Variant<State>> variants_;
};

/// Why a variant cannot run here on an image of this width; empty where it can.
[[nodiscard]] std::string unavailable_reason(const VariantInfo& variant, Index width,
                                             Border border = Border::background);

/// The index of the variant of `operation` that fits the options on an image of this width. Throws
/// std::invalid_argument where none fits, naming why the last candidate does not; where there is no
/// candidate, the techniques there are, or the ISAs of the technique.
[[nodiscard]] std::size_t choose_variant(std::string_view operation,
                                         std::span<const VariantInfo> variants, Index width,
                                         const Options& options);

/// The same, from a family's list.
template <class State>
[[nodiscard]] const Variant<State>& choose_variant(std::string_view operation,
                                                   const std::vector<Variant<State>>& variants,
                                                   Index width, const Options& options) {
  const std::vector<VariantInfo> infos(variants.begin(), variants.end());
  return variants[choose_variant(operation, std::span<const VariantInfo>(infos), width, options)];
}

}  // namespace thinbench::detail
