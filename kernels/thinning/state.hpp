// The interface of thinning states: a variant with its memory.
#pragma once

#include <memory>

#include "dispatch/variant.hpp"
#include "thinbench/rule.hpp"
#include "thinning/runtime_rule.hpp"

namespace thinbench::detail {

/// What a state is made from, already checked.
struct ThinningSetting {
  Rule rule;
  Isa isa;
  Index width;
  Index height;
  int threads;
  Border border;
  int max_iterations;
  Directions directions;                            // of the midpoint scan
  std::shared_ptr<const RuntimeRule> runtime_rule;  // of nets; nullptr for other rules
};

/// Owns all memory for thinning images of one size. Three steps, to be timed separately: load()
/// packs the image into the variant's representation; thin() leaves it unchanged, so that it may be
/// repeated; store() writes the result.
class ThinningState {
 public:
  using Setting = ThinningSetting;

  ThinningState() = default;
  virtual ~ThinningState() = default;
  ThinningState(const ThinningState&) = delete;
  ThinningState& operator=(const ThinningState&) = delete;
  ThinningState(ThinningState&&) = delete;
  ThinningState& operator=(ThinningState&&) = delete;

  virtual void load(const ConstImageView& source) = 0;
  /// Returns the number of iterations, including the last one, which changed nothing.
  virtual int thin() = 0;
  virtual void store(const ImageView& destination) const = 0;
  /// All three steps. store() need not work afterwards.
  virtual int run(const ConstImageView& source, const ImageView& destination) {
    load(source);
    const int iterations = thin();
    store(destination);
    return iterations;
  }
};

using ThinningVariant = Variant<ThinningState>;
using ThinningVariants = VariantList<ThinningState>;

}  // namespace thinbench::detail
