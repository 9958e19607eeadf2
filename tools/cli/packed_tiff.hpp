// thinbench run on TIFF images of one bit per pixel: without a byte image in between.
#pragma once

#include <string>

#include "cli/command.hpp"
#include "cli/packed_run.hpp"
#include "images/tiff.hpp"

namespace thinbench {

/// The image that stays packed, if OUT is TIFF, IN has one bit per pixel and no option needs grey
/// levels. Throws FileError where IN is damaged.
[[nodiscard]] std::optional<PackedPage> packed_tiff(const PackedOptions& options,
                                                    const BinariseOptions& binarise,
                                                    const FileBytes& in, const std::string& out);

/// Thins and prints the summary. `name` is that of IN.
int run_tiff(const RequestedThinning& thinning, const BinariseOptions& binarise, PackedPage page,
             const ThinningFiles& files, const Console& console);

}  // namespace thinbench
