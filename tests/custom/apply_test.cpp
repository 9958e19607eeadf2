// Custom rules in every engine and on every ISA against the plain tables.
#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "api/catalogue.hpp"
#include "compile/compiled_rule.hpp"
#include "compile/variants.hpp"
#include "core/exported.hpp"
#include "harness/splitmix64.hpp"
#include "reference.hpp"
#include "rules/rule_table.hpp"
#include "support/rejection.hpp"
#include "thinbench/batch.hpp"
#include "thinbench/packed.hpp"
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

struct Rules {
  std::vector<WindowTable> tables;
  reference::Repetition repetition;
};

Rules random_rule(Random& random) {
  const Kind& kind = kKinds[random.below(std::size(kKinds))];
  Rules rule;
  const int sub_iterations = random.with_chance(15) ? 1 + random.below(8) : 1 + random.below(3);
  for (int i = 0; i < sub_iterations; ++i) rule.tables.push_back(kind.make(random));
  rule.repetition.border = random.with_chance(30) ? Border::keep : Border::background;
  rule.repetition.max_iterations = 1 + random.below(12);
  return rule;
}

ByteImage random_image(Random& random, Index width, Index height) {
  ByteImage image(width, height);
  const int density = 5 + random.below(91);
  const int block = 1 + random.below(9);
  std::vector<std::uint8_t> blocks(
      static_cast<std::size_t>((width / block + 1) * (height / block + 1)));
  for (std::uint8_t& pixel : blocks) pixel = random.with_chance(density) ? 255 : 0;
  for (Index y = 0; y < height; ++y) {
    for (Index x = 0; x < width; ++x) {
      image.at(x, y) =
          blocks[static_cast<std::size_t>(y / block * (width / block + 1) + x / block)];
    }
  }
  return image;
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

Result expected(const Rules& rule, const ByteImage& source) {
  Result result = {ByteImage(source.width(), source.height()), 0};
  result.iterations =
      reference::apply_tables(rule.tables, rule.repetition, source.view(), result.image.view());
  return result;
}

std::string described(const ThinningVariant& variant, const ByteImage& image, const Rules& rule) {
  return std::string(technique_name(variant.technique)) + " at " +
         std::string(isa_name(variant.isa)) + (variant.threaded ? " with threads" : "") + ", " +
         std::to_string(image.width()) + " x " + std::to_string(image.height()) + ", " +
         std::to_string(rule.tables.size()) + " sub-iterations, border " +
         std::string(border_name(rule.repetition.border)) + ", limit " +
         std::to_string(rule.repetition.max_iterations);
}

void expect_all_variants_equal(const Rules& rule, const ByteImage& source) {
  const Result want = expected(rule, source);
  const auto compiled = std::make_shared<const CompiledRule>(rule.tables, kShort);
  for (const ThinningVariant& variant : custom_variants(compiled->adds_pixels())) {
    if (!isa_available(variant.isa) || source.width() > variant.max_width) continue;
    const ThinningSetting setting = {.rule = {},
                                     .isa = variant.isa,
                                     .width = source.width(),
                                     .height = source.height(),
                                     .threads = variant.threaded ? 3 : 1,
                                     .border = rule.repetition.border,
                                     .max_iterations = rule.repetition.max_iterations,
                                     .directions = {},
                                     .custom_rule = compiled};
    ByteImage result(source.width(), source.height());
    std::fill_n(result.view().data, result.view().stride * result.height(), kUnwritten);
    const auto state = variant.make(setting);
    for (int run = 0; run < 2; ++run) {  // the second with the memory of the first
      EXPECT_EQ(state->run(source.view(), result.view()), want.iterations)
          << described(variant, source, rule);
      EXPECT_TRUE(equal(result.view(), want.image.view())) << described(variant, source, rule);
    }
  }
}

/// Each seed is a test of its own, so that they run in parallel.
class RandomRules : public testing::TestWithParam<int> {};

TEST_P(RandomRules, equal_the_reference_in_every_variant) {
  Random random(static_cast<std::uint64_t>(GetParam()));
  for (int i = 0; i < 250 && !HasFailure(); ++i) {
    const Rules rule = random_rule(random);
    expect_all_variants_equal(rule,
                              random_image(random, random_width(random), 1 + random.below(70)));
  }
}

TEST_P(RandomRules, equal_the_reference_in_lanes) {
  Random random(static_cast<std::uint64_t>(1000 + GetParam()));
  for (int i = 0; i < 60 && !HasFailure(); ++i) {
    const Rules rule = random_rule(random);
    const auto compiled = std::make_shared<const CompiledRule>(rule.tables, kShort);
    const Index width = 1 + random.below(128);
    const Index height = 1 + random.below(40);
    const Index count = 1 + random.below(37);
    std::vector<std::uint8_t> source(static_cast<std::size_t>(count * width * height));
    std::vector<std::uint8_t> want(source.size());
    int most = 0;
    for (Index k = 0; k < count; ++k) {
      const ByteImage image = random_image(random, width, height);
      const Result result = expected(rule, image);
      most = std::max(most, result.iterations);
      const Index at = k * width * height;
      for (Index y = 0; y < height; ++y) {
        std::copy_n(image.view().row(y), width, source.data() + at + y * width);
        std::copy_n(result.image.view().row(y), width, want.data() + at + y * width);
      }
    }
    for (const Isa isa : all_isas()) {
      if (!isa_available(isa)) continue;
      const BoundRule bound = compiled->bind(isa, lane_layout(width), true);
      std::vector<std::uint8_t> result(source.size(), kUnwritten);
      const auto scratch =
          make_aligned<std::uint64_t>(static_cast<std::size_t>(lane_scratch_words(height)));
      const LaneJob job = {{source.data(), count, width, height, width, width * height},
                           {result.data(), count, width, height, width, width * height},
                           rule.repetition.max_iterations,
                           rule.repetition.border == Border::keep,
                           &bound};
      EXPECT_EQ(kernels_of<LaneKernels>(isa).custom(job, 0, count, scratch.get()), most);
      EXPECT_EQ(result, want) << isa_name(isa) << ", " << count << " images of " << width << " x "
                              << height;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRules, testing::Range(0, 8));

template <class Rule, int... subs>
CustomRule as_custom(std::integer_sequence<int, subs...>) {
  const WindowTable tables[] = {make_window_table_of<Rule, subs>()...};
  return CustomRule(tables);
}

TEST(BuiltInRules, given_as_tables_equal_themselves) {
  Random random(5);
  for_each_parallel_rule([&]<class Type>(Rule rule) {
    if constexpr (!TwoStageRule<Type>) {
      const CustomRule custom =
          as_custom<Type>(std::make_integer_sequence<int, Type::kSubIterations>{});
      for (int i = 0; i < 10; ++i) {
        const ByteImage source = random_image(random, random_width(random), 60);
        ByteImage want(source.width(), source.height());
        ByteImage result(source.width(), source.height());
        const int iterations = thin(rule, source.view(), want.view());
        EXPECT_EQ(apply(custom, source.view(), result.view()), iterations) << rule_name(rule);
        EXPECT_TRUE(equal(result.view(), want.view())) << rule_name(rule);
      }
    }
  });
}

/// Heights and widths of which a kept border leaves nothing, or one row or column.
TEST(SmallImages, equal_the_reference_in_every_variant) {
  Random random(10);
  for (const Kind& kind : kKinds) {
    for (const Border border : {Border::background, Border::keep}) {
      const Rules rule = {{kind.make(random)}, {border, 6}};
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
  for (const Border border : {Border::background, Border::keep}) {
    const Rules rule = {{kKinds[2].make(random), kKinds[2].make(random)}, {border, 4}};
    expect_all_variants_equal(rule, random_image(random, 1200, 1100));
    expect_all_variants_equal(rule, random_image(random, 500, 1300));
    const Rules adding = {{kKinds[3].make(random)}, {border, 3}};
    expect_all_variants_equal(adding, random_image(random, 500, 1300));
  }
}

TEST(ForegroundOutside, equals_the_reference_in_every_variant) {
  Random random(9);
  for (int i = 0; i < 40; ++i) {
    Rules rule = random_rule(random);
    rule.repetition.border = Border::foreground;
    const CustomRule custom(rule.tables, {Border::foreground, rule.repetition.max_iterations});
    const ByteImage source = random_image(random, random_width(random), 1 + random.below(40));
    const Result want = expected(rule, source);
    for (const ThinningVariant& variant : custom_rule_variants(custom)) {
      if (!isa_available(variant.isa) || source.width() > variant.max_width) continue;
      ByteImage result(source.width(), source.height());
      const auto state = make_custom_state(custom, variant, source.width(), source.height(),
                                           {.threads = variant.threaded ? 2 : 1});
      EXPECT_EQ(state->run(source.view(), result.view()), want.iterations);
      EXPECT_TRUE(equal(result.view(), want.image.view())) << described(variant, source, rule);
    }
  }
}

TEST(Apply, takes_stacks_and_packed_images_and_every_border) {
  Random random(6);
  for (const Border border : {Border::background, Border::keep, Border::foreground}) {
    Rules rule = {{kKinds[0].make(random), kKinds[1].make(random)}, {border, 5}};
    const CustomRule custom(rule.tables, {.border = border, .max_iterations = 5});
    constexpr Index width = 45;
    constexpr Index height = 21;
    ByteImage source = random_image(random, width, height);
    const Result want = expected(rule, source);

    ByteImage stack = copy_of(source.view());
    const auto view = stack.view();
    EXPECT_EQ(apply(custom,
                    ConstStackView{view.data, 1, width, height, view.stride, view.stride * height},
                    StackView{view.data, 1, width, height, view.stride, view.stride * height}),
              want.iterations);
    EXPECT_TRUE(equal(stack.view(), want.image.view()));

    std::vector<std::uint8_t> bits(static_cast<std::size_t>(packed_row_bytes(width) * height));
    const PackedView packed(bits.data(), width, height, BitOrder::msb_first);
    for (Index y = 0; y < height; ++y) {
      for (Index x = 0; x < width; ++x) {
        if (source.at(x, y) != 0) packed.row(y)[x / 8] |= static_cast<std::uint8_t>(0x80 >> x % 8);
      }
    }
    EXPECT_EQ(apply(custom, ConstPackedView(packed), packed), want.iterations);
    for (Index y = 0; y < height; ++y) {
      for (Index x = 0; x < width; ++x) {
        ASSERT_EQ((packed.row(y)[x / 8] >> (7 - x % 8) & 1) != 0, want.image.at(x, y) != 0);
      }
    }
  }
}

/// Foreground everywhere: images of foreground take one iteration, empty ones would take two.
TEST(Apply, places_of_a_register_without_an_image_take_no_iteration) {
  const CustomRule fill({make_window_table([](std::size_t) { return true; })});
  for (const Index width : {20, 40, 100}) {
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(3 * width * width), 255);
    const StackView images = {pixels.data(), 3, width, width, width, width * width};
    EXPECT_EQ(apply(fill, images, images), 1) << width;
    EXPECT_EQ(std::count(pixels.begin(), pixels.end(), 255), 3 * width * width) << width;
  }
}

TEST(Apply, is_safe_from_several_threads) {
  Random random(7);
  const Rules rule = {{kKinds[0].make(random)}, {Border::background, 9}};
  const ByteImage source = random_image(random, 200, 100);
  const Result want = expected(rule, source);
  std::vector<std::thread> threads;
  std::vector<int> right(4, 0);
  for (int& result : right) {
    threads.emplace_back([&] {
      const CustomRule custom(rule.tables, {.max_iterations = 9});  // all compile the same rule
      ByteImage image(200, 100);
      const int iterations = apply(custom, source.view(), image.view());
      result = iterations == want.iterations && equal(image.view(), want.image.view()) ? 1 : 0;
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(right, std::vector<int>(4, 1));
}

TEST(CustomRule, names_what_is_wrong) {
  const WindowTable life = table_from_hensel("B3/S23");
  const auto rejection = [](auto... arguments) {
    return rejection_of([&] { CustomRule rule(arguments...); });
  };
  const std::vector<WindowTable> none;
  const std::vector<WindowTable> nine(9, WindowTable{});
  EXPECT_EQ(rejection(std::span<const WindowTable>(none)),
            "a rule has 1 to 8 sub-iterations, not 0");
  EXPECT_EQ(rejection(std::span<const WindowTable>(nine)),
            "a rule has 1 to 8 sub-iterations, not 9");
  EXPECT_EQ(rejection(life),
            "this rule adds and removes pixels, so it may never end; it needs max_iterations");
  EXPECT_EQ(rejection(life, CustomRuleOptions{.max_iterations = 0}),
            "max_iterations: expected an integer of at least 1, got 0");
  EXPECT_EQ(
      rejection(life, CustomRuleOptions{.border = static_cast<Border>(9), .max_iterations = 1}),
      "border: expected background, keep or foreground, got 9");
  EXPECT_EQ(rejection(life, CustomRuleOptions{.max_iterations = 3}), "");
}

TEST(CustomRule, rejects_options_that_the_rule_has) {
  const CustomRule rule(pixel_table(WindowTable::kCentre));
  ByteImage image(3, 3);
  EXPECT_EQ(
      rejection_of([&] { apply(rule, image.view(), image.view(), {.border = Border::keep}); }),
      "a custom rule has its own options and takes no border");
  EXPECT_EQ(rejection_of([&] { apply(rule, image.view(), image.view(), {.max_iterations = 2}); }),
            "a custom rule has its own options and takes no max_iterations");
}

TEST(CompiledRules, are_shared_by_equal_tables) {
  const WindowTable table = table_from_hensel("B36/S23");
  EXPECT_EQ(CustomRule(table, {.max_iterations = 1}).compiled(),
            CustomRule(table, {.max_iterations = 7}).compiled());
}

}  // namespace
}  // namespace thinbench::detail
