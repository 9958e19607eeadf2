// The proof that comes before every time: what a job gives against what the reference gives, on one
// input.
#pragma once

#include <optional>
#include <string>

#include "harness/job.hpp"

namespace thinbench {

/// Runs the job on `input` inside larger buffers: strides exceed the width, the destination is
/// filled with garbage first, and the job has worked on another image of the same size. Returns
/// what is wrong: first differing pixel with a window round it, first differing number, bytes
/// written beside the destination, a changed input. Nothing where all is as it should be.
[[nodiscard]] std::optional<std::string> find_mismatch(Job& job, const ConstImageView& input,
                                                       const Outcome& expected);

/// The same for the three steps of a job that has a representation of its own: the kernel is called
/// twice, as when it is timed.
[[nodiscard]] std::optional<std::string> find_kernel_mismatch(Job& job, const ConstImageView& input,
                                                              const Outcome& expected);

/// A window of the image round (x, y), '#' foreground and '.' background.
[[nodiscard]] std::string window_text(const ConstImageView& image, Index x, Index y);

}  // namespace thinbench
