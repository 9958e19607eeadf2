// Variants (the implementations of an operation) and the choice among them, for all families.
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
/// Priorities within an ISA must be below this.
inline constexpr int kPrioritiesPerIsa = 100;

/// The properties that the choice depends on.
struct VariantInfo {
  Technique technique;
  Isa isa;
  bool threaded = false;        // uses several threads
  Index max_width = kAnyWidth;  // of images
  bool keeps_border = true;     // supports Border::keep
  int priority = 0;             // the highest is chosen among the variants that can run
};

/// A variant of a family; `make` makes its state.
template <class State>
struct Variant : VariantInfo {
  std::unique_ptr<State> (*make)(const typename State::Setting& setting) = nullptr;
};

/// Builds the list of variants of one operation.
template <class State>
class VariantList {
 public:
  using Make = std::unique_ptr<State> (*)(const typename State::Setting& setting);

  /// `priority` ranks variants of the same ISA. Every variant of a later ISA ranks above all of an
  /// earlier one.
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

  /// Adds one variant for a single thread and one for several threads.
  void add_with_threads(Technique technique, Isa isa, Make make, const Facts& facts) {
    add(technique, isa, make, facts);
    add(technique, isa, make, facts, true);
  }

  [[nodiscard]] std::vector<Variant<State>> take() { return std::move(variants_); }

 private:
  std::vector<Variant<State>> variants_;
};

/// Why a variant cannot run on this machine for this width and border; empty if it can.
[[nodiscard]] std::string unavailable_reason(const VariantInfo& variant, Index width,
                                             Border border = Border::background);

/// The index of the variant with the highest priority that fits the options and the width. Throws
/// std::invalid_argument if none fits, with the reason why the last candidate cannot run or,
/// without a candidate, the available techniques or ISAs.
[[nodiscard]] std::size_t choose_variant(std::string_view operation,
                                         std::span<const VariantInfo> variants, Index width,
                                         const Options& options);

/// The same for a family's list.
template <class State>
[[nodiscard]] const Variant<State>& choose_variant(std::string_view operation,
                                                   const std::vector<Variant<State>>& variants,
                                                   Index width, const Options& options) {
  const std::vector<VariantInfo> infos(variants.begin(), variants.end());
  return variants[choose_variant(operation, std::span<const VariantInfo>(infos), width, options)];
}

}  // namespace thinbench::detail
