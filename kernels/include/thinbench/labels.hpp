// Thinning of label images.
#pragma once

#include "thinbench/export.h"
#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {

/// Thins every label of `source` as if it were alone in the image: a pixel keeps its label where
/// the skeleton of the pixels with this label has it, else it becomes 0. 0 is background, and so is
/// everything outside the image; labels may be any positive numbers, in any order, and a label may
/// have several components. Border::keep refers to the image border.
///
/// Returns the maximum number of iterations over all labels, including the last iteration, which
/// changed nothing; 0 without labels. Threads share the labels.
/// Takes up to 48 bytes of memory per run of equal labels in a row, 300 per label, and per thread
/// an image of the size of the largest label, which counts as at least 32 pixels wide.
///
/// Both views must have the same size and be the same image or share no pixel. Thread-safe for
/// different destinations. Throws as thin() does, and std::invalid_argument for a rule that adds
/// pixels, which would belong to no label, for Border::foreground, for a negative label, a
/// side above 2^29 and more than 2^31 pixels; then nothing is written. If it throws std::bad_alloc,
/// the destination may be written in part.
THINBENCH_API int thin_labels(const Rule& rule, ConstLabelView source, LabelView destination,
                              const Thinning& thinning = {}, const Execution& execution = {});

}  // namespace thinbench
