// Files thinned into files.
#pragma once

#include <functional>
#include <string>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/scan_request.hpp"
#include "cli/thinning_request.hpp"
#include "images/binarise.hpp"
#include "images/pnm.hpp"

namespace thinbench {

struct ThinningFiles {
  std::string in;
  std::string out;
};

// All return "NAME: 90 x 40, 7 iterations, 1200 foreground pixels before, 130 after, 0.042 ms",
// without an end of line.

/// Remarks on the foreground go to the console.
[[nodiscard]] std::string thin_image_file(const RequestedThinning& thinning, FileBytes in,
                                          const std::string& out, const BinariseOptions& binarise,
                                          const Console& console);

[[nodiscard]] std::string scan_image_file(const RequestedScan& scan, FileBytes in,
                                          const std::string& out, const BinariseOptions& binarise,
                                          const Console& console);

/// Thins an image in place, then calls `save`.
[[nodiscard]] std::string thin_packed_image(const RequestedThinning& thinning,
                                            const PackedView& image,
                                            const std::function<void()>& save);

/// Without a byte image in between.
[[nodiscard]] std::string thin_packed_file(const RequestedThinning& thinning, FileBytes in,
                                           const std::string& out, const PackedFormat& format);

/// Throws UsageError for options that choose the foreground among grey levels.
void reject_for_packed_files(const Options& of_binarise);

}  // namespace thinbench
