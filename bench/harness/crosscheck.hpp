// The proof that comes before every time: a variant's output and number of passes against the
// reference's, on one input.
#pragma once

#include <optional>
#include <string>

#include "harness/test_images.hpp"
#include "reference.hpp"
#include "thinning/plan.hpp"

namespace thinbench {

/// "operation/technique/isa/threads", as rows are called everywhere.
[[nodiscard]] std::string row_name(std::string_view operation, const ThinningVariant& variant,
                                   int threads);

/// What the reference makes of an input.
struct Expected {
  ByteImage skeleton;
  int passes = 0;
};

/// Throws std::logic_error where the operation has no reference.
[[nodiscard]] Expected expected_of(std::string_view operation, const ConstByteView& input);

/// Runs the plan on `input` inside larger buffers: strides exceed the width, the destination is
/// filled with garbage first, and the plan has worked on another image of the same size. Returns
/// what is wrong: first differing pixel with a window round it, passes, bytes written beside the
/// destination, a changed input or margin. Nothing where all is as it should be.
[[nodiscard]] std::optional<std::string> find_mismatch(ThinningPlan& plan,
                                                       const ConstByteView& input,
                                                       const Expected& expected);

/// A window of the two images round (x, y), '#' dark and '.' light.
[[nodiscard]] std::string window_text(const ConstByteView& image, Index x, Index y);

}  // namespace thinbench
