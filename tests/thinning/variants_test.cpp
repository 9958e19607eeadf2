// Every variant of every rule against the reference, with both borders and iteration limits.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/edge_case_images.hpp"
#include "support/reference_thinning.hpp"
#include "support/rule_parameters.hpp"
#include "support/variant_of.hpp"

namespace thinbench::detail {
namespace {

constexpr int kLimits[] = {1, 2, 3, kUnlimited};
constexpr std::uint8_t kUnwritten = 77;

/// One result per element of kLimits. To save time, each continues from the one before, which gives
/// the same; see reference/repetition_test.cpp.
std::vector<Thinned> expected_by_limit(const Rule& rule, Border border, const ByteImage& image) {
  std::vector<Thinned> all;
  all.push_back(thinned_by_reference(rule, image, {border, 1}));
  bool changed = !equal(all[0].image.view(), image.view());
  while (all.size() < std::size(kLimits)) {
    const Thinned& before = all.back();
    Thinned next = {copy_of(before.image.view()), before.iterations};
    if (changed) {
      const int limit = all.size() + 1 < std::size(kLimits) ? 1 : kUnlimited;
      next = thinned_by_reference(rule, before.image, {border, limit});
      next.iterations += before.iterations;
      changed = !equal(next.image.view(), before.image.view());
    }
    all.push_back(std::move(next));
  }
  return all;
}

struct NamedState {
  std::string name;
  std::unique_ptr<ThinningState> state;
};

/// States of all available variants for images of this size; threaded ones if `with_threads`.
std::vector<NamedState> states_of(const Rule& rule, Index width, Index height,
                                  const Thinning& thinning, bool with_threads) {
  const ThinningParameters parameters = thinning_parameters(rule, thinning);
  std::vector<NamedState> states;
  for (const ThinningVariant& variant : variants_of(parameters)) {
    if (!unavailable_reason(variant, width).empty()) continue;
    if (variant.threaded && !with_threads) continue;
    states.push_back({name_of(variant), make_state(variant, width, height, parameters, 3)});
  }
  return states;
}

/// Describes the first difference of a state's result; empty if there is none. `result` is a buffer
/// of the image's size.
std::string difference(ThinningState& state, const ByteImage& image, const Thinned& expected,
                       ByteImage& result) {
  const ImageView out = result.view();
  fill(out, kUnwritten);
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

class EveryVariant : public testing::TestWithParam<RuleAndBorder> {
 protected:
  [[nodiscard]] static const Rule& rule() { return GetParam().rule; }
  [[nodiscard]] static Border border() { return GetParam().border; }

  /// Checks all limits on all images of a size.
  static void expect_all_equal(Index width, Index height, bool with_threads) {
    const auto images = edge_case_images::of_size(width, height, static_cast<std::uint64_t>(width));
    ByteImage result(width, height);
    std::vector<std::vector<Thinned>> expected;  // by image, then limit
    for (const ByteImage& image : images) {
      expected.push_back(expected_by_limit(rule(), border(), image));
    }
    for (std::size_t limit = 0; limit < std::size(kLimits); ++limit) {
      const Thinning thinning = {border(), kLimits[limit]};
      for (const NamedState& one : states_of(rule(), width, height, thinning, with_threads)) {
        for (std::size_t i = 0; i < images.size(); ++i) {
          ASSERT_EQ(difference(*one.state, images[i], expected[i][limit], result), "")
              << one.name << ", " << width << " x " << height << ", image " << i << ", limit "
              << kLimits[limit];
        }
      }
    }
  }
};

bool is_net(const Rule& rule) {
  return rule.name().starts_with("net");
}

/// Fewer sizes for large images, and for nets fewer still, because the references are slow.
std::vector<Index> heights_for(Index width, bool is_net) {
  if (width <= 129) return {1, 2, 3, 15, 16, 17, 70};
  if (width == 513 && !is_net) return {1, 2, 3, 70};
  return {1, 2, 3, 17};
}

TEST_P(EveryVariant, equals_the_reference_at_every_size_and_limit) {
  constexpr Index kBandRows = 16;  // lower images run on one thread
  const auto with_threads = [](Index width, Index height) {
    return height > kBandRows && (width == 2 || width == 65 || width >= 513);
  };
  for (const Index width : {1, 2, 3, 63, 64, 65, 127, 128, 129, 511, 512, 513, 1030}) {
    for (const Index height : heights_for(width, is_net(rule()))) {
      expect_all_equal(width, height, with_threads(width, height));
      if (HasFatalFailure()) return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, EveryVariant, all_rules_and_borders(), rule_and_border_test_name);

std::vector<RuleAndBorder> study_rules_and_borders() {
  std::vector<RuleAndBorder> all;
  for (const auto& info : study::kStudyRules) {
    add_with_borders(std::string(info.name), study::make_rule(info.rule), all);
  }
  add_with_borders("other_weights", study::make_net(damaged_net(), Activation::sigmoid), all);
  return all;
}

INSTANTIATE_TEST_SUITE_P(StudyRules, EveryVariant, testing::ValuesIn(study_rules_and_borders()),
                         rule_and_border_test_name);

}  // namespace
}  // namespace thinbench::detail
