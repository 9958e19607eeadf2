// Rules given by random tables, in every engine and on every ISA, against the plain tables.
#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "compile/rule_body.hpp"
#include "harness/splitmix64.hpp"
#include "reference.hpp"
#include "support/filled_image.hpp"
#include "support/made_image.hpp"
#include "support/untouched.hpp"
#include "support/variant_of.hpp"
#include "thinbench/many.hpp"
#include "thinbench/rule_notation.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench::detail {
namespace {

constexpr SearchEffort kShort = {150'000};
constexpr std::uint8_t kUnwritten = 77;

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

struct Kind {
  const char* name;
  WindowTable (*make)(Random& random);
};

bool centre_of(std::size_t window) {
  return (window >> WindowTable::kCentre & 1) != 0;
}

constexpr Kind kKinds[] = {
    {"dense",
     [](Random& random) {
       return make_window_table([&](std::size_t) { return random.with_chance(50); });
     }},
    {"sparse",
     [](Random& random) {
       return make_window_table(
           [&](std::size_t window) { return centre_of(window) != random.with_chance(3); });
     }},
    {"removing",
     [](Random& random) {
       return make_window_table(
           [&](std::size_t window) { return centre_of(window) && random.with_chance(75); });
     }},
    {"adding",
     [](Random& random) {
       return make_window_table(
           [&](std::size_t window) { return centre_of(window) || random.with_chance(10); });
     }},
    {"isotropic",
     [](Random& random) {
       std::string notation = "B";
       for (char count = '0'; count <= '8'; ++count)
         notation += random.with_chance(30) ? std::string(1, count) : "";
       notation += "/S";
       for (char count = '0'; count <= '8'; ++count)
         notation += random.with_chance(40) ? std::string(1, count) : "";
       return table_from_hensel(notation);
     }},
};

struct RandomRule {
  std::vector<WindowTable> tables;
  reference::Repetition repetition;

  [[nodiscard]] Rule rule() const {
    return Rule(tables, {repetition.border, repetition.max_iterations});
  }
};

RandomRule random_rule(Random& random) {
  const Kind& kind = kKinds[random.below(std::size(kKinds))];
  RandomRule rule;
  const int sub_iterations = random.with_chance(15) ? 1 + random.below(8) : 1 + random.below(3);
  for (int i = 0; i < sub_iterations; ++i) rule.tables.push_back(kind.make(random));
  rule.repetition.border = random.with_chance(30) ? Border::keep : Border::background;
  rule.repetition.max_iterations = 1 + random.below(12);
  return rule;
}

/// As the rule's own, but compiled quickly.
ThinningParameters parameters_of(const RandomRule& rule) {
  if (rule.repetition.border == Border::foreground) return thinning_parameters(rule.rule(), {});
  const auto body = std::make_shared<RuleBody>();
  body->compiled = std::make_shared<const CompiledRule>(rule.tables, kShort);
  return {body, rule.repetition.border, rule.repetition.max_iterations, false};
}

ByteImage random_image(Random& random, Index width, Index height) {
  const int density = 5 + random.below(91);
  const int block = 1 + random.below(9);
  std::vector<std::uint8_t> blocks(
      static_cast<std::size_t>((width / block + 1) * (height / block + 1)));
  for (std::uint8_t& pixel : blocks) pixel = random.with_chance(density) ? 255 : 0;
  return image_by(width, height, [&](Index x, Index y) {
    return blocks[static_cast<std::size_t>(y / block * (width / block + 1) + x / block)];
  });
}

/// Widths around words and registers, and any.
Index random_width(Random& random) {
  constexpr Index widths[] = {1,   2,   31,  32,  33,  63,  64,  65, 127,
                              128, 129, 255, 257, 511, 512, 513, 600};
  return random.with_chance(40) ? widths[random.below(std::size(widths))] : 1 + random.below(150);
}

struct Result {
  ByteImage image;
  int iterations;
};

Result expected(const RandomRule& rule, const ByteImage& source) {
  Result result = {ByteImage(source.width(), source.height()), 0};
  result.iterations =
      reference::apply_tables(rule.tables, rule.repetition, source.view(), result.image.view());
  return result;
}

std::string described(const ByteImage& image, const RandomRule& rule) {
  return std::to_string(image.width()) + " x " + std::to_string(image.height()) + ", " +
         std::to_string(rule.tables.size()) + " sub-iterations, border " +
         std::string(border_name(rule.repetition.border)) + ", limit " +
         std::to_string(rule.repetition.max_iterations);
}

void expect_all_variants_equal(const RandomRule& rule, const ByteImage& source) {
  const Result want = expected(rule, source);
  ByteImage result(source.width(), source.height());
  for_each_state(parameters_of(rule), source.width(), source.height(), 3,
                 [&](ThinningState& state, const std::string& name) {
                   fill(result.view(), kUnwritten);
                   for (int run = 0; run < 2; ++run) {  // the second with the memory of the first
                     EXPECT_EQ(state.run(source.view(), result.view()), want.iterations)
                         << name << ", " << described(source, rule);
                     EXPECT_TRUE(equal(result.view(), want.image.view()))
                         << name << ", " << described(source, rule);
                   }
                 });
}

/// Each seed is a test of its own, so that they run in parallel.
class RandomRules : public testing::TestWithParam<int> {};

TEST_P(RandomRules, equal_the_reference_in_every_variant) {
  Random random(static_cast<std::uint64_t>(GetParam()));
  for (int i = 0; i < 250 && !HasFailure(); ++i) {
    const RandomRule rule = random_rule(random);
    expect_all_variants_equal(rule,
                              random_image(random, random_width(random), 1 + random.below(70)));
  }
}

/// Large images: tiles run the first sub-iterations while they load.
TEST(RandomRules, tiles_equal_words_with_one_to_eight_sub_iterations) {
  Random random(17);
  const ByteImage source = random_image(random, 2099, 531);
  ByteImage by_words(source.width(), source.height());
  ByteImage by_tiles(source.width(), source.height());
  for (int sub_iterations = 1; sub_iterations <= kMaxSubIterations; ++sub_iterations) {
    RandomRule rule;
    for (int i = 0; i < sub_iterations; ++i) rule.tables.push_back(kKinds[2].make(random));
    rule.repetition.border = sub_iterations % 2 == 0 ? Border::keep : Border::background;
    rule.repetition.max_iterations = 1 + sub_iterations % 3;
    int iterations = 0;
    for_each_state(parameters_of(rule), source.width(), source.height(), 2,
                   [&](ThinningState& state, const std::string& name) {
                     if (name == "simd_bitpacked at baseline") {
                       iterations = state.run(source.view(), by_words.view());
                     }
                     if (name.rfind("simd_bitpacked_tiles", 0) != 0) return;
                     for (int run = 0; run < 2; ++run) {
                       EXPECT_EQ(state.run(source.view(), by_tiles.view()), iterations) << name;
                       EXPECT_TRUE(equal(by_tiles.view(), by_words.view()))
                           << name << described(source, rule);
                     }
                   });
  }
}

/// Images of one size, one below the other.
ByteImage stacked(const std::vector<ByteImage>& images) {
  const Index height = images.front().height();
  ByteImage stack(images.front().width(), height * static_cast<Index>(images.size()));
  for (std::size_t i = 0; i < images.size(); ++i) {
    for (Index y = 0; y < height; ++y) {
      std::copy_n(images[i].view().row(y), stack.width(),
                  stack.view().row(static_cast<Index>(i) * height + y));
    }
  }
  return stack;
}

TEST_P(RandomRules, equal_the_reference_in_lanes) {
  Random random(static_cast<std::uint64_t>(1000 + GetParam()));
  RandomRule rule;
  for (int i = 0; i < 60 && !HasFailure(); ++i) {
    if (i % 3 == 0) rule = random_rule(random);  // compiling it takes longest
    if (random.with_chance(25)) rule.repetition.border = Border::foreground;
    const Index width = 1 + random.below(128);
    const Index height = 1 + random.below(40);
    const Index count = 1 + random.below(37);
    std::vector<ByteImage> sources;
    std::vector<ByteImage> wanted;
    int most = 0;
    for (Index k = 0; k < count; ++k) {
      sources.push_back(random_image(random, width, height));
      Result result = expected(rule, sources.back());
      most = std::max(most, result.iterations);
      wanted.push_back(std::move(result.image));
    }
    const ByteImage source = stacked(sources);
    const ByteImage want = stacked(wanted);
    const auto stack = [&](const auto& view) {
      return ConstStackView{view.data, count, width, height, view.stride, view.stride * height};
    };
    for (const Isa isa : all_isas()) {
      if (!isa_available(isa)) continue;
      ByteImage result(width, height * count);
      const ImageView to = result.view();
      EXPECT_EQ(thin_stack(rule.rule(), stack(source.view()),
                           {to.data, count, width, height, to.stride, to.stride * height}, {},
                           {.isa = isa}),
                most);
      EXPECT_TRUE(equal(to, want.view()))
          << isa_name(isa) << ", " << count << " images of " << described(sources.front(), rule);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRules, testing::Range(0, 8));

TEST(BuiltInRules, given_as_tables_equal_themselves) {
  Random random(5);
  for (const RuleInfo& info : kRules) {
    const Rule built_in = info.rule;
    if (built_in.sub_iterations().empty()) continue;
    const Rule tables(built_in.sub_iterations());
    for (int i = 0; i < 10; ++i) {
      const ByteImage source = random_image(random, random_width(random), 60);
      ByteImage want(source.width(), source.height());
      ByteImage result(source.width(), source.height());
      const int iterations = thin(built_in, source.view(), want.view());
      EXPECT_EQ(thin(tables, source.view(), result.view()), iterations) << info.name;
      EXPECT_TRUE(equal(result.view(), want.view())) << info.name;
    }
  }
}

constexpr Border kBorders[] = {Border::background, Border::keep, Border::foreground};

/// Heights and widths of which a kept border leaves nothing, or one row or column.
TEST(SmallImages, equal_the_reference_in_every_variant) {
  Random random(10);
  for (const Kind& kind : kKinds) {
    for (const Border border : kBorders) {
      const RandomRule rule = {{kind.make(random)}, {border, 6}};
      for (const Index height : {1, 2, 3, 4}) {
        for (const Index width : {1, 3, 65}) {
          expect_all_variants_equal(rule, random_image(random, width, height));
        }
      }
    }
  }
}

/// Tiles shared among threads, and more rows than the row kernel has bands of eight.
TEST(LargeImages, equal_the_reference_in_every_variant) {
  Random random(8);
  for (const Border border : kBorders) {
    const RandomRule rule = {{kKinds[2].make(random), kKinds[2].make(random)}, {border, 4}};
    expect_all_variants_equal(rule, random_image(random, 1200, 1100));
    expect_all_variants_equal(rule, random_image(random, 500, 1300));
    const RandomRule adding = {{kKinds[3].make(random)}, {border, 3}};
    expect_all_variants_equal(adding, random_image(random, 500, 1300));
  }
}

TEST(ForegroundOutside, equals_the_reference_in_every_variant) {
  Random random(9);
  for (int i = 0; i < 40; ++i) {
    RandomRule rule = random_rule(random);
    rule.repetition.border = Border::foreground;
    expect_all_variants_equal(rule,
                              random_image(random, random_width(random), 1 + random.below(40)));
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

TEST(Rules, are_compiled_safely_by_several_threads) {
  Random random(7);
  const RandomRule rule = {{kKinds[0].make(random)}, {Border::background, 9}};
  const ByteImage source = random_image(random, 200, 100);
  const Result want = expected(rule, source);
  std::vector<std::thread> threads;
  std::vector<int> right(4, 0);
  for (int& result : right) {
    threads.emplace_back([&] {
      ByteImage image(200, 100);
      const int iterations = thin(rule.rule(), source.view(), image.view());
      result = iterations == want.iterations && equal(image.view(), want.image.view()) ? 1 : 0;
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(right, std::vector<int>(4, 1));
}

TEST(Rules, name_what_is_wrong) {
  const WindowTable life = table_from_hensel("B3/S23");
  const std::vector<WindowTable> nine(9, WindowTable{});
  ByteImage image(3, 3);
  const std::pair<std::function<void()>, const char*> cases[] = {
      {[&] { Rule(std::span(nine).first(0)); }, "a rule has 1 to 8 sub-iterations, not 0"},
      {[&] { Rule(std::span(nine)); }, "a rule has 1 to 8 sub-iterations, not 9"},
      {[&] { Rule(life, {.max_iterations = 0}); }, "expected an integer of at least 1, got 0"},
      {[&] { Rule(life, {.border = static_cast<Border>(9)}); }, "border: expected background, "},
      {[&] { thin(Rule(life), image.view(), image.view()); },
       "custom: this rule adds and removes pixels, so it may never end; it needs a limit "
       "(max_iterations)"},
      {[&] { static_cast<void>(Rule::named("magic")); }, "rule: expected a name, got 'magic'"}};
  for (const auto& [call, part] : cases) expect_rejected(call, part);
}

TEST(Rules, with_equal_tables_share_what_was_compiled) {
  const WindowTable table = table_from_hensel("B36/S23");
  EXPECT_EQ(detail::body_of(Rule(table, {.max_iterations = 1}))->compiled,
            detail::body_of(Rule(table, {.max_iterations = 7}))->compiled);
}

}  // namespace
}  // namespace thinbench::detail
