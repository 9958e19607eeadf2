// The interface of thinning states. A state is a variant with its memory.
#pragma once

#include <memory>

#include "dispatch/variant.hpp"
#include "thinbench/packed.hpp"
#include "thinbench/rule.hpp"
#include "thinning/runtime_rule.hpp"

namespace thinbench::detail {

class CompiledRule;

/// The parameters of a state, already validated.
struct ThinningSetting {
  Rule rule;
  Isa isa;
  Index width;
  Index height;
  int threads;
  Border border;
  int max_iterations;
  Directions directions;                                      // midpoint scan only
  std::shared_ptr<const RuntimeRule> runtime_rule = nullptr;  // nets: their model
  std::shared_ptr<const CompiledRule> custom_rule = nullptr;  // custom rules only
};

/// Owns all memory for thinning images of one size. Its three steps can be timed separately: load()
/// packs the image into the variant's representation; thin() does not modify the packed image, so
/// it can be repeated; store() writes the result. Images are bytes or packed. Not thread-safe.
class ThinningState {
 public:
  using Setting = ThinningSetting;

  ThinningState() = default;
  virtual ~ThinningState() = default;
  ThinningState(const ThinningState&) = delete;
  ThinningState& operator=(const ThinningState&) = delete;

  virtual void load(const ConstImageView& source) = 0;
  virtual void load(const ConstPackedView& source) = 0;
  /// Returns the number of iterations, including the last one, which changed nothing.
  virtual int thin() = 0;
  virtual void store(const ImageView& destination) const = 0;
  virtual void store(const PackedView& destination) const = 0;
  /// Does all three steps. A later store() is not supported.
  virtual int run(const ConstImageView& source, const ImageView& destination) {
    return run_steps(source, destination);
  }
  virtual int run(const ConstPackedView& source, const PackedView& destination) {
    return run_steps(source, destination);
  }

 private:
  template <class Source, class Destination>
  int run_steps(const Source& source, const Destination& destination) {
    load(source);
    const int iterations = thin();
    store(destination);
    return iterations;
  }
};

using ThinningVariant = Variant<ThinningState>;
using ThinningVariants = VariantList<ThinningState>;

}  // namespace thinbench::detail
