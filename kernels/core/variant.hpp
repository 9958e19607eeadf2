// Operations, their variants (implementations), and the choice among them, for all families.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/checks.hpp"
#include "core/thread_team.hpp"
#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"

namespace thinbench::detail {

inline constexpr Index kAnyWidth = std::numeric_limits<Index>::max();
/// Priorities within an ISA must be below this.
inline constexpr int kPrioritiesPerIsa = 100;

/// The properties that the choice depends on.
struct VariantInfo {
  std::string_view technique;
  Isa isa;
  bool threaded = false;        // uses several threads
  Index max_width = kAnyWidth;  // of images
  int priority = 0;             // the highest is chosen among the variants that can run
};

/// The parameters of a state, already validated: those of its family and these.
template <class Parameters>
struct Setting : Parameters {
  Isa isa;
  Index width;
  Index height;
  int threads;
};

/// A variant of a family. `State` has Parameters; `make` makes one.
template <class State>
struct Variant : VariantInfo {
  using Make = std::unique_ptr<State> (*)(const Setting<typename State::Parameters>& setting);
  Make make = nullptr;
};

/// Builds the list of variants of one operation.
template <class State>
class VariantList {
 public:
  using Make = typename Variant<State>::Make;

  /// `priority` ranks variants of the same ISA. Every variant of a later ISA ranks above all of an
  /// earlier one.
  struct Facts {
    int priority = 0;
    Index max_width = kAnyWidth;
  };

  void add(std::string_view technique, Isa isa, Make make, const Facts& facts,
           bool threaded = false) {
    const int priority = static_cast<int>(isa) * kPrioritiesPerIsa + facts.priority;
    variants_.push_back({{technique, isa, threaded, facts.max_width, priority}, make});
  }

  /// Adds one variant for a single thread and one for several threads.
  void add_with_threads(std::string_view technique, Isa isa, Make make, const Facts& facts) {
    add(technique, isa, make, facts);
    add(technique, isa, make, facts, true);
  }

  [[nodiscard]] std::vector<Variant<State>> take() { return std::move(variants_); }

 private:
  std::vector<Variant<State>> variants_;
};

/// One exact function from an image to a result, with its variants.
template <class Key, class State>
struct Operation {
  using StateType = State;

  Key key;
  std::string_view name;
  std::string_view description;
  std::vector<Variant<State>> variants;
};

/// An object that is never destroyed, as threads may still run when the program ends.
template <class Type>
[[nodiscard]] const Type& kept(Type object) {
  return *new Type(std::move(object));
}

/// Why a variant cannot run on this machine for this width; empty if it can.
[[nodiscard]] std::string unavailable_reason(const VariantInfo& variant, Index width);

/// Rejects a variant that cannot run on this machine for this width.
void require_available(const VariantInfo& variant, Index width);

/// The ISA of functions without variants. Rejects threads out of range and an ISA that is not
/// available.
[[nodiscard]] Isa checked_isa(const Execution& execution);

/// The index of the variant with the highest priority that fits; one thread for images below
/// kMinPixelsForThreads and where no variant uses several. Throws std::invalid_argument for threads
/// out of range, and if no variant fits, with the reason why the last candidate cannot run or,
/// without a candidate, the available ISAs.
[[nodiscard]] std::size_t choose_variant(std::string_view operation,
                                         std::span<const VariantInfo> variants, Index width,
                                         Index height, const Execution& execution);

/// The same for a family's list.
template <class State>
[[nodiscard]] const Variant<State>& choose_variant(std::string_view operation,
                                                   const std::vector<Variant<State>>& variants,
                                                   Index width, Index height,
                                                   const Execution& execution) {
  const std::vector<VariantInfo> infos(variants.begin(), variants.end());
  return variants[choose_variant(operation, infos, width, height, execution)];
}

/// The state of a variant for images of this size. Before anything is allocated, throws
/// std::invalid_argument for a size or parameters that the family rejects (State::check), threads
/// out of range, and a variant that cannot run here. States of images without pixels have no
/// memory, whatever the size.
template <class State>
[[nodiscard]] std::unique_ptr<State> make_state(const Variant<State>& variant, Index width,
                                                Index height,
                                                const typename State::Parameters& parameters,
                                                int threads) {
  require_size(width, height);
  State::check(parameters, width, height);
  require_threads(threads);
  require_available(variant, width);
  const bool empty = width == 0 || height == 0;
  return variant.make({parameters, variant.isa, empty ? 0 : width, empty ? 0 : height,
                       variant.threaded ? threads : 1});
}

/// The state of the best variant: what public functions use.
template <class Key, class State>
[[nodiscard]] std::unique_ptr<State> make_best_state(const Operation<Key, State>& operation,
                                                     Index width, Index height,
                                                     const typename State::Parameters& parameters,
                                                     const Execution& execution) {
  require_size(width, height);
  const Variant<State>& variant =
      choose_variant(operation.name, operation.variants, width, height, execution);
  return make_state(variant, width, height, parameters, execution.threads);
}

/// The operation with this key, an enumerator; `name` is for the message.
template <class Key, class State>
[[nodiscard]] const Operation<Key, State>& operation_with(
    Key key, std::span<const Operation<Key, State>> operations, const char* name) {
  for (const Operation<Key, State>& operation : operations) {
    if (operation.key == key) return operation;
  }
  require(false, std::string(name) + ": expected one of the enumeration, got number " +
                     std::to_string(static_cast<int>(key)));
  return operations.front();
}

}  // namespace thinbench::detail
