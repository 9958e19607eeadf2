// The interface of thinning states. A state is a variant with its memory.
#pragma once

#include <memory>

#include "compile/rule_body.hpp"
#include "core/variant.hpp"
#include "thinbench/packed.hpp"
#include "thinbench/rule.hpp"

namespace thinbench::detail {

/// What changes pixels, already validated.
struct ThinningParameters {
  SharedRule rule;  // its complement for Border::foreground
  Border border;    // background or keep
  int max_iterations;
  bool complemented;  // states exchange foreground and background when they load and store
};

using ThinningSetting = Setting<ThinningParameters>;

/// Owns all memory for thinning images of one size. Its three steps can be timed separately: load()
/// packs the image into the variant's representation; thin() does not modify the packed image, so
/// it can be repeated; store() writes the result. Images are bytes or packed. Not thread-safe.
class ThinningState {
 public:
  using Parameters = ThinningParameters;

  static void check(const ThinningParameters&, Index width, Index height) {
    require_max_pixels(width, height);
  }

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
using ThinningOperation = Operation<Rule, ThinningState>;

}  // namespace thinbench::detail
