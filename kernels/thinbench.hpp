// The library in one header: thin a picture, let the library choose how.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "catalog.hpp"
#include "image/byte_image.hpp"
#include "nets/make_model.hpp"
#include "thinning/plan.hpp"

namespace thinbench {

/// How to compute. What is left open is chosen: the fastest technique that this machine offers.
struct ThinningOptions {
  std::optional<Technique> technique = std::nullopt;
  std::optional<Isa> isa = std::nullopt;
  int threads = 1;  // at most, where the technique is left open: see worthwhile_threads
  /// For nets: what make_model.hpp makes of other weights than the paper's.
  std::shared_ptr<const RuleModel> model = nullptr;
  std::optional<Border> border = std::nullopt;          // instead of the operation's own
  std::optional<Directions> directions = std::nullopt;  // of a scan; all where none are given
};

/// How many of the threads of `options` an image of this size is given: all where a technique is
/// asked for, else one below kMinPixelsForThreads and for operations that no technique shares.
[[nodiscard]] int worthwhile_threads(const ThinningOperation& operation,
                                     const ThinningOptions& options, Index width, Index height);

/// The variant that `options` ask for on an image of this width. Throws std::invalid_argument,
/// naming what is wrong and what there is, where no variant fits.
[[nodiscard]] const ThinningVariant& choose_variant(const ThinningOperation& operation, Index width,
                                                    const ThinningOptions& options = {});

/// Thins `source` (0 is light, anything else dark) into `destination` (0 and 255) by the operation
/// of this name and returns the number of passes, the last, which changed nothing, included.
///
/// Outside the image everything is light, unless `options.border` says otherwise. Strides are bytes
/// from row to row and may be larger than the width. The two views have one size; they are the same
/// image or share no pixel (views of one buffer that lie side by side have equal strides). Throws
/// std::invalid_argument for an unknown name, sizes that differ or are negative, a stride below the
/// width, a null image, a partial overlap, or options that no variant fits.
int thin(std::string_view operation, ConstImageView source, ImageView destination,
         const ThinningOptions& options = {});

}  // namespace thinbench
