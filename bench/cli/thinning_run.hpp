// Files thinned into files, by an operation of the library or by a custom rule.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

#include "api/catalogue.hpp"
#include "cli/command.hpp"
#include "images/binarise.hpp"
#include "images/packed_file.hpp"

namespace thinbench {

struct ThinningFiles {
  std::string in;
  std::string out;
};

/// What thins them.
struct Thinning {
  std::string name;
  std::span<const detail::ThinningVariant> variants;
  std::function<std::unique_ptr<detail::ThinningState>(
      const detail::ThinningVariant& variant, Index width, Index height, const Options& options)>
      make_state;
};

[[nodiscard]] Thinning thinning_of(const detail::ThinningOperation& operation);

// All return the summary, "NAME/TECHNIQUE/ISA/THREADS: 90 x 40, ...", without an end of line.

/// Remarks on the foreground go to the console.
[[nodiscard]] std::string thin_image_file(const Thinning& thinning, const ThinningFiles& files,
                                          const BinariseOptions& binarise, const Options& how,
                                          const Console& console);

/// Thins an image in place, then calls `save`.
[[nodiscard]] std::string thin_packed_image(const Thinning& thinning, const PackedView& image,
                                            const Options& how, const std::function<void()>& save);

/// Without a byte image in between.
[[nodiscard]] std::string thin_packed_file(const Thinning& thinning, const ThinningFiles& files,
                                           const PackedFormat& format, const Options& how);

/// Throws UsageError for options that choose the foreground among grey levels.
void reject_for_packed_files(const BinariseOptions& options);

}  // namespace thinbench
