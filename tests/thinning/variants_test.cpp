// Every variant of every rule against the reference, with both borders and limits of iterations.
#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "api/catalogue.hpp"
#include "reference.hpp"
#include "support/splitmix64.hpp"
#include "thinning/edge_case_images.hpp"

namespace thinbench::detail {
namespace {

constexpr int kLimits[] = {1, 2, 3, kUnlimited};
constexpr std::uint8_t kUnwritten = 77;

struct Expected {
  ByteImage image;
  int iterations;
};

Expected expected_of(Rule rule, Border border, int limit, const ByteImage& image) {
  Expected expected = {ByteImage(image.width(), image.height()), 0};
  expected.iterations =
      reference::thinning(rule)({border, limit}, image.view(), expected.image.view());
  return expected;
}

/// By limit, as in kLimits. Each goes on where the one before ended, which is the same, see
/// reference/repetition_test.cpp, and takes less time.
std::vector<Expected> expected_by_limit(Rule rule, Border border, const ByteImage& image) {
  std::vector<Expected> all;
  all.push_back(expected_of(rule, border, 1, image));
  bool changed = rule != Rule::midpoint_scan && !equal(all[0].image.view(), image.view());
  while (all.size() < std::size(kLimits)) {
    const Expected& before = all.back();
    Expected next = {copy_of(before.image.view()), before.iterations};
    if (changed) {
      const int limit = all.size() + 1 < std::size(kLimits) ? 1 : kUnlimited;
      next = expected_of(rule, border, limit, before.image);
      next.iterations += before.iterations;
      changed = !equal(next.image.view(), before.image.view());
    }
    all.push_back(std::move(next));
  }
  return all;
}

/// A variant at work.
struct NamedState {
  std::string name;
  std::unique_ptr<ThinningState> state;
};

/// All variants that run here on images of this size; those with threads only where `with_threads`.
std::vector<NamedState> states_of(Rule rule, Index width, Index height, Options options,
                                  bool with_threads) {
  const ThinningOperation& operation = operation_of(rule);
  std::vector<NamedState> states;
  for (const ThinningVariant& variant : operation.variants) {
    if (!unavailable_reason(variant, width, options.border).empty()) continue;
    if (variant.threaded && !with_threads) continue;
    options.threads = variant.threaded ? 3 : 1;
    states.push_back({std::string(technique_name(variant.technique)) + " at " +
                          std::string(isa_name(variant.isa)) + ", threads " +
                          std::to_string(options.threads),
                      make_state(operation, variant, width, height, options)});
  }
  return states;
}

/// What is wrong with the result of a state; empty where nothing is. `result` is of the image's
/// size.
std::string difference(ThinningState& state, const ByteImage& image, const Expected& expected,
                       ByteImage& result) {
  const ImageView out = result.view();
  for (Index y = 0; y < out.height; ++y) std::fill_n(out.row(y), out.width, kUnwritten);
  const int iterations = state.run(image.view(), out);
  for (Index y = 0; y < out.height; ++y) {
    if (std::equal(out.row(y), out.row(y) + out.width, expected.image.view().row(y))) continue;
    for (Index x = 0; x < out.width; ++x) {
      if (result.at(x, y) == expected.image.at(x, y)) continue;
      return "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") is " +
             std::to_string(result.at(x, y));
    }
  }
  if (iterations == expected.iterations) return "";
  return std::to_string(iterations) + " iterations instead of " +
         std::to_string(expected.iterations);
}

class EveryVariant : public testing::TestWithParam<std::tuple<Rule, Border>> {
 protected:
  [[nodiscard]] static Rule rule() { return std::get<Rule>(GetParam()); }
  [[nodiscard]] static Border border() { return std::get<Border>(GetParam()); }

  /// All limits on all images of a size.
  static void expect_all_equal(Index width, Index height, bool with_threads) {
    const auto images = edge_case_images::of_size(width, height, static_cast<std::uint64_t>(width));
    ByteImage result(width, height);
    std::vector<std::vector<Expected>> expected;  // by image, then limit
    for (const ByteImage& image : images) {
      expected.push_back(expected_by_limit(rule(), border(), image));
    }
    for (std::size_t limit = 0; limit < std::size(kLimits); ++limit) {
      const Options options = {.border = border(), .max_iterations = kLimits[limit]};
      for (const NamedState& one : states_of(rule(), width, height, options, with_threads)) {
        for (std::size_t i = 0; i < images.size(); ++i) {
          ASSERT_EQ(difference(*one.state, images[i], expected[i][limit], result), "")
              << one.name << ", " << width << " x " << height << ", image " << i << ", limit "
              << kLimits[limit];
        }
      }
    }
  }
};

/// The references take long: large images of a part of the sizes, and of fewer for nets.
std::vector<Index> heights_for(Index width, bool is_net) {
  if (width <= 129) return {1, 2, 3, 15, 16, 17, 70};
  if (width == 513 && !is_net) return {1, 2, 3, 70};
  return {1, 2, 3, 17};
}

TEST_P(EveryVariant, equals_the_reference_at_every_size_and_limit) {
  constexpr Index kBandRows = 16;  // fewer are not shared among threads
  const auto with_threads = [](Index width, Index height) {
    return height > kBandRows && (width == 2 || width == 65 || width >= 513);
  };
  for (const Index width : {1, 2, 3, 63, 64, 65, 127, 128, 129, 511, 512, 513, 1030}) {
    for (const Index height : heights_for(width, operation_of(rule()).is_net)) {
      expect_all_equal(width, height, with_threads(width, height));
      if (HasFatalFailure()) return;
    }
  }
}

TEST_P(EveryVariant, equals_the_reference_on_all_four_by_four) {
  std::vector<std::vector<NamedState>> by_limit;
  for (const int limit : kLimits) {
    const Options options = {.border = border(), .max_iterations = limit};
    by_limit.push_back(states_of(rule(), 4, 4, options, false));
  }
  ByteImage result(4, 4);
  for (std::uint64_t bits = 0; bits < 65536; ++bits) {
    // One limit for each image, and a quarter of the variants.
    const std::uint64_t random = splitmix64(5, bits);
    const std::size_t limit = random % 4;
    const ByteImage image = image_of_bits(4, 4, bits);
    const Expected expected = expected_of(rule(), border(), kLimits[limit], image);
    const auto& states = by_limit[limit];
    for (std::size_t i = (random >> 8) % 4; i < states.size(); i += 4) {
      ASSERT_EQ(difference(*states[i].state, image, expected, result), "")
          << states[i].name << ", image " << bits << ", limit " << kLimits[limit];
    }
  }
}

std::vector<Rule> all_rules() {
  std::vector<Rule> rules;
  for (const RuleInfo& info : kRules) rules.push_back(info.rule);
  return rules;
}

INSTANTIATE_TEST_SUITE_P(Rules, EveryVariant,
                         testing::Combine(testing::ValuesIn(all_rules()),
                                          testing::Values(Border::background, Border::keep)),
                         [](const auto& tested) {
                           return std::string(rule_name(std::get<Rule>(tested.param))) +
                                  "_border_" +
                                  std::string(border_name(std::get<Border>(tested.param)));
                         });

}  // namespace
}  // namespace thinbench::detail
