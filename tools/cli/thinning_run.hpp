// Files thinned into files.
#pragma once

#include <functional>
#include <string>
#include <string_view>

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

// All tell "NAME: 90 x 40, 7 iterations, 1200 foreground pixels before, 130 after, 0.042 ms".

/// `apply` works in place and returns the number of iterations. Summary and remarks on the
/// foreground go to the console.
int run_image(std::string_view name, const std::function<int(const ImageView&)>& apply,
              FileBytes in, const std::string& out, const BinariseOptions& binarise,
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
