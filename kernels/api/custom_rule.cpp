#include "thinbench/custom_rule.hpp"

#include <algorithm>

#include "custom/compiled_rule.hpp"
#include "image/checks.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {

static_assert(CustomRule::kMaxSubIterations == detail::kMaxSubIterations);

namespace {

/// Foreground and background exchanged: what is foreground outside becomes background.
std::vector<WindowTable> complemented(std::span<const WindowTable> tables) {
  std::vector<WindowTable> result;
  for (const WindowTable& table : tables) {
    result.push_back(make_window_table(
        [&](std::size_t window) { return !table[WindowTable::kWindows - 1 - window]; }));
  }
  return result;
}

}  // namespace

CustomRule::CustomRule(std::span<const WindowTable> sub_iterations,
                       const CustomRuleOptions& options)
    : tables_(sub_iterations.begin(), sub_iterations.end()), options_(options) {
  using detail::require;
  require(!tables_.empty() && tables_.size() <= kMaxSubIterations,
          "a rule has 1 to " + std::to_string(kMaxSubIterations) + " sub-iterations, not " +
              std::to_string(tables_.size()));
  require(static_cast<std::size_t>(options.border) < kBorderNames.size(),
          "border: expected background, keep or foreground, got " +
              std::to_string(static_cast<int>(options.border)));
  require(options.max_iterations >= 1, "max_iterations: expected an integer of at least 1, got " +
                                           std::to_string(options.max_iterations));
  const bool outside = options.border == Border::foreground;
  compiled_ = detail::compile(outside ? complemented(tables_) : tables_,
                              options.optimise ? detail::kThoroughSearch : detail::kFastSearch);
  require(options.max_iterations != kUnlimited ||
              !(compiled_->adds_pixels() && compiled_->removes_pixels()),
          "this rule adds and removes pixels, so it may never end; it needs max_iterations");
}

int CustomRule::gates(std::size_t sub_iteration) const {
  detail::require(sub_iteration < tables_.size(), "sub-iteration " + std::to_string(sub_iteration) +
                                                      " of a rule with " +
                                                      std::to_string(tables_.size()));
  return static_cast<int>(compiled_->circuit(sub_iteration).gates.size());
}

int apply(const CustomRule& rule, ConstImageView source, ImageView destination,
          const Options& options) {
  detail::check_views(source, destination, detail::InPlace::allowed);
  return Thinner(rule, source.width, source.height, options)(source, destination);
}

}  // namespace thinbench
