// Files thinned into files, by a rule of the library or by a custom rule.
#pragma once

#include <functional>
#include <string>
#include <variant>

#include "cli/command.hpp"
#include "images/binarise.hpp"
#include "images/packed_file.hpp"
#include "thinbench/custom_rule.hpp"
#include "thinbench/options.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {

struct ThinningFiles {
  std::string in;
  std::string out;
};

/// What thins them.
struct Thinning {
  std::string name;
  std::variant<Rule, CustomRule> rule;
};

[[nodiscard]] Thinning thinning_by(Rule rule);

struct RunSummary {
  Index width;
  Index height;
  int iterations;
  Index foreground_before;
  Index foreground_after;
  double milliseconds;
};

/// "90 x 40, 7 iterations, 1200 foreground pixels before, 130 after, 0.042 ms".
[[nodiscard]] std::string text_of(const RunSummary& run);

// All return "NAME: " and the summary, without an end of line.

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
