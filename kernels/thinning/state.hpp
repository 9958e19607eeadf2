// One variant of thinning at work: what every engine implements, and what it is made from.
#pragma once

#include <memory>

#include "dispatch/variant.hpp"
#include "thinbench/rule.hpp"
#include "thinning/runtime_rule.hpp"

namespace thinbench::detail {

/// What a state needs to know beside its technique. Checked where it is made.
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

/// Owns all memory that thinning images of one size needs. The three steps, for timing them apart:
/// load() packs the image into the variant's own representation; thin() leaves it as it is, so that
/// it may be repeated; store() writes what thin() found.
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
  /// Returns the number of iterations, the last one, which changed nothing, included.
  virtual int thin() = 0;
  virtual void store(const ImageView& destination) const = 0;
  /// All three. Need not leave anything for the steps.
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
