// Rules of every kind, by every variant and in lanes, against the references: what the cross-check
// does not vary, which is limits of iterations, rules that are neither built in nor named there,
// and random tables.
#include <algorithm>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "compile/rule_body.hpp"
#include "engines/lanes.hpp"
#include "harness/splitmix64.hpp"
#include "harness/test_images.hpp"
#include "rules/trained_cluster.hpp"
#include "support/made_image.hpp"
#include "support/reference_thinning.hpp"
#include "support/rule_parameters.hpp"
#include "support/variant_of.hpp"
#include "thinbench/many.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench::detail {
namespace {

using reference::Repetition;

constexpr std::uint8_t kUnwritten = 77;
#ifdef _WIN32
constexpr int kOtherThreads = 1;
#else
constexpr int kOtherThreads = 3;
#endif
constexpr Border kBorders[] = {Border::background, Border::keep, Border::foreground};

std::string described(const ByteImage& image, const Rule& rule, const Repetition& repetition) {
  return std::to_string(image.width()) + " x " + std::to_string(image.height()) + ", " +
         std::to_string(rule.sub_iterations().size()) + " sub-iterations, border " +
         std::string(border_name(repetition.border)) + ", limit " +
         std::to_string(repetition.max_iterations);
}

/// Twice, the second time in place and with the memory of the first.
void expect_every_variant_equal(const Rule& rule, const Repetition& repetition,
                                const ByteImage& image, int threads = 3) {
  const Thinned expected = thinned_by_reference(rule, image, repetition);
  const auto parameters = thinning_parameters(rule, {repetition.border, repetition.max_iterations});
  for_each_state(parameters, image.width(), image.height(), threads,
                 [&](ThinningState& state, const std::string& name) {
                   ByteImage result = filled_image(image.width(), image.height(), kUnwritten);
                   EXPECT_EQ(state.run(image.view(), result.view()), expected.iterations)
                       << name << ", " << described(image, rule, repetition);
                   EXPECT_TRUE(equal(result.view(), expected.image.view()))
                       << name << ", " << described(image, rule, repetition);
                   ByteImage in_place = copy_of(image.view());
                   state.run(in_place.view(), in_place.view());
                   EXPECT_TRUE(equal(in_place.view(), expected.image.view()))
                       << name << " in place, " << described(image, rule, repetition);
                 });
}

/// The images of a stack, one below the other, thinned at every ISA.
void expect_stack_equal(const Rule& rule, const Repetition& repetition, const ByteImage& image,
                        Index height) {
  const Index width = image.width(), count = image.height() / height;
  ByteImage expected(width, image.height());
  const auto stack = [&](const ImageView& view) {
    return StackView{view.data, count, width, height, view.stride, view.stride * height};
  };
  ByteImage source = copy_of(image.view());
  const StackView from = stack(source.view()), to = stack(expected.view());
  int iterations = 0;
  for (Index i = 0; i < count; ++i) {
    iterations =
        std::max(iterations, thin_by_reference(rule, repetition, from.image(i), to.image(i)));
  }
  for (const Isa isa : all_isas()) {
    if (!isa_available(isa)) continue;
    ByteImage result = filled_image(width, image.height(), kUnwritten);
    EXPECT_EQ(thin_stack(rule, from, stack(result.view()),
                         {repetition.border, repetition.max_iterations}, {.isa = isa}),
              iterations);
    EXPECT_TRUE(equal(result.view(), expected.view()))
        << isa_name(isa) << ", " << count << " images of " << width << " x " << height << " in "
        << described(image, rule, repetition);
  }
}

class EveryRule : public testing::TestWithParam<RuleAndBorder> {};

/// Under Windows, where threads are slow to start, only the image of large objects has them.
TEST_P(EveryRule, equals_the_reference_at_every_size_and_limit) {
  const auto& [name, rule, border] = GetParam();
  for (const Index width : {1, 3, 64, 65, 129, 513, 1030}) {
    for (const Index height : {1, 2, 17, 70}) {
      for (const int limit : {1, 2, kUnlimited}) {
        const auto seed = static_cast<std::uint64_t>(width);
        expect_every_variant_equal(rule, {border, limit}, noise_image(width, height, 60, 1, seed),
                                   kOtherThreads);
        expect_every_variant_equal(rule, {border, limit}, noise_image(width, height, 93, 2, seed));
        expect_every_variant_equal(rule, {border, limit}, filled_image(width, height, 255),
                                   kOtherThreads);
        if (HasFailure()) return;
      }
    }
  }
}

/// To save time, a rule has one border at each width.
TEST_P(EveryRule, equals_the_reference_in_lanes_of_every_width) {
  const auto& [name, rule, border] = GetParam();
  for (Index width = 1 + static_cast<Index>(border); width <= kMaxLaneWidth + 2; width += 3) {
    const std::uint64_t random = splitmix64(17, static_cast<std::uint64_t>(width));
    const Index height = 1 + static_cast<Index>(random % 70), count = 1 + width % 37;
    const int limit = std::array{1, 2, 3, kUnlimited}[random >> 32 & 3];
    const int percent = 50 + static_cast<int>(random >> 40 & 31);
    const ByteImage noise = noise_image(width, height * count, percent, 1 + width % 4, random);
    expect_stack_equal(rule, {border, limit}, noise, height);
    if (HasFailure()) return;
  }
}

TEST_P(EveryRule, equals_the_reference_in_lanes_on_all_images_of_four_by_four) {
  const ByteImage all = image_by(
      4, 4 * 65536, [](Index x, Index y) { return (y / 4 >> (y % 4 * 4 + x) & 1) != 0 ? 255 : 0; });
  for (const int limit : {1, kUnlimited}) {
    expect_stack_equal(GetParam().rule, {GetParam().border, limit}, all, 4);
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, EveryRule, all_rules_and_borders(), rule_and_border_test_name);

class EveryRuleOfTheStudy : public EveryRule {};

std::vector<RuleAndBorder> study_rules_and_borders() {
  std::vector<RuleAndBorder> all;
  for (const auto& info : study::kStudyRules) {
    add_with_borders(std::string(info.name), study::make_rule(info.rule), all);
  }
  add_with_borders("other_weights", study::make_net(damaged_net(), Activation::sigmoid), all);
  ClusterWeights cluster = kTrainedCluster;
  cluster.nets[5].neuron = {{}, 1.0F};  // always foreground
  add_with_borders("other_cluster", study::make_net(cluster), all);
  return all;
}

TEST_P(EveryRuleOfTheStudy, equals_the_reference_with_limits) {
  const auto& [name, rule, border] = GetParam();
  for (const Index width : {1, 65, 130, 513}) {
    for (const Index height : {2, 50}) {
      for (const int limit : {1, 2, kUnlimited}) {
        expect_every_variant_equal(rule, {border, limit}, noise_image(width, height, 90, 1, 4));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, EveryRuleOfTheStudy, testing::ValuesIn(study_rules_and_borders()),
                         rule_and_border_test_name);

class Random {
 public:
  explicit Random(std::uint64_t seed) : seed_(seed) {}
  /// From 0 to limit - 1.
  int below(int limit) {
    return static_cast<int>(splitmix64(seed_, drawn_++) % static_cast<std::uint64_t>(limit));
  }
  bool with_chance(int percent) { return below(100) < percent; }

 private:
  std::uint64_t seed_;
  std::uint64_t drawn_ = 0;
};

enum class Kind : std::uint8_t { dense, sparse, removing, adding, isotropic };

WindowTable random_table(Kind kind, Random& random) {
  if (kind == Kind::isotropic) {
    std::string birth = "B", survival = "/S";
    for (const char count : std::string("012345678")) {
      if (random.with_chance(30)) birth += count;
      if (random.with_chance(40)) survival += count;
    }
    return table_from_hensel(birth + survival);
  }
  return make_window_table([&](std::size_t window) {
    const bool centre = (window >> WindowTable::kCentre & 1) != 0;
    if (kind == Kind::dense) return random.with_chance(50);
    if (kind == Kind::sparse) return centre != random.with_chance(3);
    if (kind == Kind::removing) return centre && random.with_chance(75);
    return centre || random.with_chance(10);
  });
}

/// As the constructor of Rule makes it, but with a short search for circuits.
Rule quickly_compiled(const std::vector<WindowTable>& tables) {
  const auto with_short_search = [](const RuleBody& from) {
    const auto own = from.compiled->tables();
    auto body = std::make_shared<RuleBody>(from);
    body->compiled = std::make_shared<const CompiledRule>(
        std::vector<WindowTable>(own.begin(), own.end()), SearchEffort{150'000});
    return body;
  };
  const auto body = with_short_search(*body_of(Rule(tables)));
  body->complement = with_short_search(*body->complement);
  return RuleAccess::make(body);
}

Rule random_rule(Kind kind, int sub_iterations, Random& random) {
  std::vector<WindowTable> tables;
  for (int i = 0; i < sub_iterations; ++i) tables.push_back(random_table(kind, random));
  return quickly_compiled(tables);
}

Rule random_rule(Random& random) {
  const auto kind = static_cast<Kind>(random.below(5));
  return random_rule(kind, 1 + random.below(random.with_chance(15) ? kMaxSubIterations : 3),
                     random);
}

Repetition random_repetition(Random& random) {
  return {kBorders[random.below(3)], 1 + random.below(12)};
}

ByteImage random_image(Random& random, Index width, Index height) {
  const int percent = 5 + random.below(91);
  return noise_image(width, height, percent, 1 + random.below(9),
                     static_cast<std::uint64_t>(random.below(1 << 30)));
}

/// Around words and registers, any, and so small that a kept border leaves nothing or one line.
ByteImage random_image(Random& random) {
  constexpr Index widths[] = {1,   2,   3,   31,  32,  33,  63,  64,  65,
                              127, 128, 129, 255, 257, 511, 512, 513, 600};
  const bool is_special = random.with_chance(40);
  const Index width = is_special ? widths[random.below(std::size(widths))] : 1 + random.below(150);
  return random_image(random, width, 1 + random.below(random.with_chance(20) ? 4 : 70));
}

/// Each seed is a test of its own, so that they run in parallel.
class RandomRules : public testing::TestWithParam<int> {};

TEST_P(RandomRules, equal_the_reference_in_every_variant) {
  Random random(static_cast<std::uint64_t>(GetParam()));
  for (int i = 0; i < 250 && !HasFailure(); ++i) {
    const Rule rule = random_rule(random);
    expect_every_variant_equal(rule, random_repetition(random), random_image(random));
  }
}

TEST_P(RandomRules, equal_the_reference_in_lanes) {
  Random random(static_cast<std::uint64_t>(1000 + GetParam()));
  for (int i = 0; i < 20 && !HasFailure(); ++i) {
    const Rule rule = random_rule(random);  // compiling it takes longest
    for (int size = 0; size < 3; ++size) {
      const Index width = 1 + random.below(kMaxLaneWidth), height = 1 + random.below(40);
      const Index count = 1 + random.below(37);
      expect_stack_equal(rule, random_repetition(random),
                         random_image(random, width, height * count), height);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRules, testing::Range(0, 8));

/// Tiles run the first sub-iterations while they load, and threads share them; the tall image has
/// more rows than the row kernel has bands of eight.
TEST(LargeImages, equal_the_reference_in_every_variant_with_one_to_eight_sub_iterations) {
  Random random(8);
  const ByteImage wide = random_image(random, 2099, 531), tall = random_image(random, 500, 1300);
  for (int sub_iterations = 1; sub_iterations <= kMaxSubIterations; ++sub_iterations) {
    const Rule removing = random_rule(Kind::removing, sub_iterations, random);
    const Repetition repetition = {kBorders[sub_iterations % 3], 1 + sub_iterations % 3};
    expect_every_variant_equal(removing, repetition, sub_iterations % 4 == 0 ? tall : wide);
    if (sub_iterations > 3) continue;
    const Rule adding = random_rule(Kind::adding, sub_iterations, random);
    expect_every_variant_equal(adding, repetition, tall);
  }
}

/// The row kernel has at most 64 bands, of at least eight rows.
TEST(TallImages, with_as_many_bands_as_there_may_be_equal_the_reference) {
  for (const Border border : {Border::background, Border::keep}) {
    for (const Index height : {512, 514, 520, 576, 578}) {
      expect_every_variant_equal(Rule::guo_hall, {border, kUnlimited},
                                 noise_image(90, height, 93, 2, 1));
    }
  }
}

TEST(BuiltInRules, given_as_tables_equal_themselves) {
  Random random(5);
  for (const RuleInfo& info : kRules) {
    const Rule built_in = info.rule;
    if (built_in.sub_iterations().empty()) continue;
    const Rule tables(built_in.sub_iterations());
    for (int i = 0; i < 10; ++i) {
      const ByteImage source = random_image(random);
      ByteImage want(source.width(), source.height());
      ByteImage result(source.width(), source.height());
      const int iterations = thin(built_in, source.view(), want.view());
      EXPECT_EQ(thin(tables, source.view(), result.view()), iterations) << info.name;
      EXPECT_TRUE(equal(result.view(), want.view())) << info.name;
    }
  }
}

/// Foreground everywhere: images of foreground take one iteration, empty ones would take two.
TEST(Lanes, without_an_image_take_no_iteration) {
  const Rule fill(make_window_table([](std::size_t) { return true; }));
  for (const Index width : {20, 40, 100}) {
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(3 * width * width), 255);
    const StackView images = {pixels.data(), 3, width, width, width, width * width};
    EXPECT_EQ(thin_stack(fill, images, images), 1) << width;
    EXPECT_EQ(std::count(pixels.begin(), pixels.end(), 255), 3 * width * width) << width;
  }
}

/// No pointer beyond the only image is computed, which the sanitizers would notice.
TEST(Lanes, of_one_image_allow_any_distance_to_the_next) {
  for (const Index distance : {std::numeric_limits<Index>::min(), Index{0}}) {
    std::vector<std::uint8_t> pixels(20 * 20, 255);
    const StackView image = {pixels.data(), 1, 20, 20, 20, distance};
    EXPECT_GT(thin_stack(Rule::guo_hall, image, image), 1);
    EXPECT_EQ(std::erase(pixels, 0), 399);
  }
}

TEST(Rules, are_compiled_safely_by_several_threads) {
  Random random(7);
  const Rule rule = random_rule(Kind::dense, 1, random);
  const ByteImage source = random_image(random, 200, 100);
  const Thinned want = thinned_by_reference(rule, source, {Border::background, 9});
  std::vector<std::thread> threads;
  std::vector<int> right(4, 0);
  for (int& result : right) {
    threads.emplace_back([&] {
      const ByteImage image = thinned(rule, source, {.max_iterations = 9});
      result = equal(image.view(), want.image.view()) ? 1 : 0;
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(right, std::vector<int>(4, 1));
}

TEST(Rules, with_equal_tables_share_what_was_compiled) {
  const WindowTable table = table_from_hensel("B36/S23");
  EXPECT_EQ(detail::body_of(Rule(table, {.max_iterations = 1}))->compiled,
            detail::body_of(Rule(table, {.max_iterations = 7}))->compiled);
}

}  // namespace
}  // namespace thinbench::detail
