// thinbench run on TIFF images of 1 bit per pixel: without a byte image in between.
#pragma once

#include <string>

#include "cli/packed_run.hpp"
#include "images/binarise.hpp"

namespace thinbench {

/// Whether a run goes from such an image to another.
[[nodiscard]] bool is_tiff_run(const PackedOptions& options, const BinariseOptions& binarise,
                               const ThinningFiles& files);

/// Thins and prints remarks and the summary. Pixels and remarks are those of the
/// same image read as a grey one.
int run_tiff(const RequestedThinning& thinning, const BinariseOptions& binarise,
             const ThinningFiles& files, const Console& console);

}  // namespace thinbench
