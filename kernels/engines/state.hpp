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

/// Owns all memory for thinning images of one size. Not thread-safe.
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

  /// Thins bytes or packed bits. Both views have the size of the setting. Returns the number of
  /// iterations, including the last one, which changed nothing.
  virtual int run(const ConstImageView& source, const ImageView& destination) = 0;
  virtual int run(const ConstPackedView& source, const PackedView& destination) = 0;
};

using ThinningVariant = Variant<ThinningState>;
using ThinningVariants = VariantList<ThinningState>;
using ThinningOperation = Operation<Rule, ThinningState>;

}  // namespace thinbench::detail
