// Variants: implementations of an operation, one type for all families, and the choice among them.
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
/// Priorities within an ISA are below this.
inline constexpr int kPrioritiesPerIsa = 100;

/// The properties that a choice depends on.
struct VariantInfo {
  Technique technique;
  Isa isa;
  bool threaded = false;        // uses several threads
  Index max_width = kAnyWidth;  // of images
  bool keeps_border = true;     // supports Border::keep
  int priority = 0;             // of the variants that can run, the highest is chosen
};

/// A variant in a family of states that are made from a `State::Setting`.
template <class State>
struct Variant : VariantInfo {
  std::unique_ptr<State> (*make)(const typename State::Setting& setting) = nullptr;
};

/// Builds the list of variants of one operation.
template <class State>
class VariantList {
 public:
  using Make = std::unique_ptr<State> (*)(const typename State::Setting& setting);

  /// `priority` is that within the ISA: any variant of a later ISA precedes all of an earlier one.
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

  /// One variant for one thread and one for several.
  void add_with_threads(Technique technique, Isa isa, Make make, const Facts& facts) {
    add(technique, isa, make, facts);
    add(technique, isa, make, facts, true);
  }

  [[nodiscard]] std::vector<Variant<State>> take() { return std::move(variants_); }

 private:
  std::vector<Variant<State>> variants_;
};

/// Why a variant cannot run on this machine on an image of this width; empty where it can.
[[nodiscard]] std::string unavailable_reason(const VariantInfo& variant, Index width,
                                             Border border = Border::background);

/// The index of the variant that fits the options and the width. Throws std::invalid_argument where
/// none fits: with the reason why the last candidate does not or, without a candidate, with the
/// available techniques or ISAs.
[[nodiscard]] std::size_t choose_variant(std::string_view operation,
                                         std::span<const VariantInfo> variants, Index width,
                                         const Options& options);

/// The same from a family's list.
template <class State>
[[nodiscard]] const Variant<State>& choose_variant(std::string_view operation,
                                                   const std::vector<Variant<State>>& variants,
                                                   Index width, const Options& options) {
  const std::vector<VariantInfo> infos(variants.begin(), variants.end());
  return variants[choose_variant(operation, std::span<const VariantInfo>(infos), width, options)];
}

}  // namespace thinbench::detail
