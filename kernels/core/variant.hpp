// Operations, their variants (implementations), and the choice among them, for all families.
#pragma once

#include <cstdint>
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
  int priority = 0;             // the highest is chosen
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
  struct Ranking {
    int priority = 0;
    Index max_width = kAnyWidth;
  };

  void add(std::string_view technique, Isa isa, Make make, const Ranking& ranking,
           bool threaded = false) {
    const int priority = static_cast<int>(isa) * kPrioritiesPerIsa + ranking.priority;
    variants_.push_back({{technique, isa, threaded, ranking.max_width, priority}, make});
  }

  /// Adds one variant for a single thread and one for several threads.
  void add_with_threads(std::string_view technique, Isa isa, Make make, const Ranking& ranking) {
    add(technique, isa, make, ranking);
    add(technique, isa, make, ranking, true);
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

/// An object that lives until the program ends, as threads may still run then.
template <class Type>
[[nodiscard]] const Type& never_destroyed(Type object) {
  return *new Type(std::move(object));
}

/// Why a variant cannot run on this machine for this width; empty if it can.
[[nodiscard]] std::string unavailable_reason(const VariantInfo& variant, Index width);

/// A set of ISAs; bit i stands for static_cast<Isa>(i).
using IsaSet = std::uint32_t;

/// Those that this machine has, up to the requested one. Throws std::invalid_argument if that is
/// none of them, or threads are out of range.
[[nodiscard]] IsaSet usable_isas(const Execution& execution);

/// The ISA of functions without variants. Throws as usable_isas() does.
[[nodiscard]] Isa checked_isa(const Execution& execution);
/// Throws as usable_isas() does.
inline void require_execution(const Execution& execution) {
  static_cast<void>(usable_isas(execution));
}

/// Whether threads share an image of this size.
[[nodiscard]] bool use_threads(Index width, Index height, const Execution& execution);

/// The best variant for images of this size: one with threads, if they share the image and one has
/// them; the highest priority. Throws as usable_isas() does. The list has a variant of the baseline
/// for images of any width on one thread.
template <class State>
[[nodiscard]] const Variant<State>& choose_variant(const std::vector<Variant<State>>& variants,
                                                   Index width, Index height,
                                                   const Execution& execution) {
  const IsaSet isas = usable_isas(execution);
  const bool threads = use_threads(width, height, execution);
  const Variant<State>* best = nullptr;
  for (const Variant<State>& one : variants) {
    const bool is_usable = (isas >> static_cast<int>(one.isa) & 1) != 0;
    if (!is_usable || width > one.max_width || (one.threaded && !threads)) continue;
    if (best == nullptr ||
        std::pair(one.threaded, one.priority) > std::pair(best->threaded, best->priority)) {
      best = &one;
    }
  }
  return *best;  // NOLINT(clang-analyzer-core.uninitialized.UndefReturn): the baseline's fits
}

/// The state of a variant that can run, for images of a size and with parameters that its family
/// takes. States of images without pixels have no memory, whatever the size.
template <class State>
[[nodiscard]] std::unique_ptr<State> made(const Variant<State>& variant, Index width, Index height,
                                          const typename State::Parameters& parameters,
                                          int threads) {
  const bool empty = width == 0 || height == 0;
  return variant.make({parameters, variant.isa, empty ? 0 : width, empty ? 0 : height,
                       variant.threaded ? threads : 1});
}

/// The state of the best variant: what public functions use. Before anything is allocated, throws
/// std::invalid_argument for a size or parameters that the family rejects (State::check), threads
/// out of range, and an ISA that is not available.
template <class State>
[[nodiscard]] std::unique_ptr<State> make_best_state(const std::vector<Variant<State>>& variants,
                                                     Index width, Index height,
                                                     const typename State::Parameters& parameters,
                                                     const Execution& execution) {
  require_size(width, height);
  State::check(parameters, width, height);
  return made(choose_variant(variants, width, height, execution), width, height, parameters,
              execution.threads);
}

template <class Key, class State>
[[nodiscard]] std::unique_ptr<State> make_best_state(const Operation<Key, State>& operation,
                                                     Index width, Index height,
                                                     const typename State::Parameters& parameters,
                                                     const Execution& execution) {
  return make_best_state(operation.variants, width, height, parameters, execution);
}

/// The state of a given variant, for the study and tests. Throws as make_best_state() does, and for
/// a variant that cannot run here.
template <class State>
[[nodiscard]] std::unique_ptr<State> make_state(const Variant<State>& variant, Index width,
                                                Index height,
                                                const typename State::Parameters& parameters,
                                                int threads) {
  require_size(width, height);
  State::check(parameters, width, height);
  require_threads(threads);
  const std::string reason = unavailable_reason(variant, width);
  require(reason.empty(), [&] {
    return std::string(variant.technique) + " at " + std::string(isa_name(variant.isa)) +
           " cannot run: " + reason;
  });
  return made(variant, width, height, parameters, threads);
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
