// thin() and Thinner: results, chosen variants, rejected arguments.
#include "thinbench/thinning.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/filled_image.hpp"
#include "support/isa_parameters.hpp"
#include "support/reference_thinning.hpp"
#include "support/rejection.hpp"
#include "support/rule_parameters.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/named_rules.hpp"
#include "thinning/operations.hpp"

namespace thinbench {
namespace {

constexpr std::uint8_t kUntouched = 0x5A;

ByteImage untouched(Index width, Index height) {
  return filled_image(width, height, kUntouched);
}

bool is_untouched(const ConstImageView& view) {
  return is_filled(view, kUntouched);
}

class ThinBy : public testing::TestWithParam<RuleAndBorder> {};

TEST_P(ThinBy, equals_the_reference_by_default_at_any_width) {
  const auto& [name, rule, border] = GetParam();
  for (const Index width : {1, 64, 510, 512, 513, 1100, 2000}) {
    const ByteImage image = noise_image(width, 20, 95, 1, 2);
    const Thinned expected = thinned_by_reference(rule, image, {border});
    Thinner thinner(rule, width, 20, {border, kUnlimited});
    for (const int threads : {1, 3}) {
      ByteImage out(width, 20);
      EXPECT_EQ(thin(rule, image.view(), out.view(), {border, kUnlimited}, {.threads = threads}),
                expected.iterations);
      EXPECT_TRUE(equal(out.view(), expected.image.view())) << width;
      EXPECT_EQ(thinner(image.view(), out.view()), expected.iterations);
      EXPECT_TRUE(equal(out.view(), expected.image.view())) << width;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, ThinBy, all_rules_and_borders(), rule_and_border_test_name);

TEST(Thin, does_what_a_rule_says_unless_told_otherwise) {
  const ByteImage image = noise_image(90, 30, 60, 3, 6);
  for (const NamedRule& named : named_rules()) {
    const Rule rule = Rule::named(named.name);
    for (const Thinning& thinning : {Thinning{}, Thinning{Border::foreground, 2}}) {
      const Border border = thinning.border.value_or(named.border);
      const Thinned expected = thinned_by_reference(
          rule, image, {border, thinning.max_iterations.value_or(named.max_iterations)});
      ByteImage out(90, 30);
      EXPECT_EQ(thin(rule, image.view(), out.view(), thinning), expected.iterations) << named.name;
      EXPECT_TRUE(equal(out.view(), expected.image.view())) << named.name;
    }
  }
}

TEST(Thinner, runs_a_net_that_equals_the_rule_as_the_rule) {
  const Rule rule = Rule::naccache_shinghal;
  const Rule net(kPaperTwoLayer, Activation::linear);
  for (const Index width : {600, 2048}) {
    const ByteImage image = noise_image(width, 70, 90, 2, 3);
    Thinner by_rule(rule, width, 70);
    Thinner by_net(net, width, 70);
    EXPECT_EQ(by_net.technique(), by_rule.technique());
    EXPECT_EQ(by_net.isa(), by_rule.isa());
    ByteImage expected(width, 70);
    ByteImage out(width, 70);
    EXPECT_EQ(by_rule(image.view(), expected.view()), by_net(image.view(), out.view()));
    EXPECT_TRUE(equal(out.view(), expected.view())) << width;
  }
  EXPECT_EQ(&detail::thinning_variants(*net.body()), &detail::thinning_variants(*rule.body()));
}

TEST(Thin, large_image_has_the_same_result_on_one_and_on_three_threads) {
  const ByteImage image = noise_image(1100, 1000, 60, 12, 17);
  for (const auto& [name, rule, border] : rules_and_borders()) {
    if (name == "guo_hall" || name == "midpoint_scan" || name == "adding_tables") {
      ByteImage one(1100, 1000);
      ByteImage three(1100, 1000);
      const Thinning thinning = {border, 4};
      EXPECT_EQ(thin(rule, image.view(), one.view(), thinning),
                thin(rule, image.view(), three.view(), thinning, {.threads = 3}));
      EXPECT_TRUE(equal(one.view(), three.view())) << name << ", border " << border_name(border);
    }
  }
}

TEST(Thin, takes_one_iteration_for_images_without_pixels) {
  for (const auto& [width, height] : {std::pair<Index, Index>{0, 0}, {0, 7}, {7, 0}}) {
    for (const RuleInfo& info : kRules) {
      for (const Border border : {Border::background, Border::keep}) {
        EXPECT_EQ(thin(info.rule, ConstImageView(nullptr, width, height), {nullptr, width, height},
                       {border}),
                  1)
            << info.name;
      }
    }
  }
}

TEST(Thin, treats_any_nonzero_byte_as_foreground_and_writes_0_and_255) {
  ByteImage image = noise_image(70, 12, 90, 1, 3);
  const Thinned expected = thinned_by_reference(Rule::zhang_suen, image);
  for (Index y = 0; y < 12; ++y) {
    for (Index x = 0; x < 70; ++x) {
      if (image.at(x, y) != 0) image.at(x, y) = static_cast<std::uint8_t>(1 + (x * 7 + y) % 255);
    }
  }
  ByteImage out = untouched(70, 12);
  EXPECT_EQ(thin(Rule::zhang_suen, image.view(), out.view()), expected.iterations);
  EXPECT_TRUE(equal(out.view(), expected.image.view()));
}

TEST(Thin, accepts_disjoint_views_of_one_buffer) {
  const ByteImage image = noise_image(20, 10, 90, 1, 3);
  const Thinned expected = thinned_by_reference(Rule::guo_hall, image);
  for (const Index first : {0, 20}) {  // the source's column; the destination is the other half
    ByteImage buffer(40, 10);
    const ImageView source{buffer.view().data + first, 20, 10, buffer.view().stride};
    const ImageView destination{buffer.view().data + 20 - first, 20, 10, buffer.view().stride};
    for (Index y = 0; y < 10; ++y) std::copy_n(image.view().row(y), 20, source.row(y));
    EXPECT_EQ(rejection_of([&] { thin(Rule::guo_hall, source, destination); }), "");
    EXPECT_TRUE(equal(destination, expected.image.view()));
    EXPECT_TRUE(equal(source, image.view()));
  }
}

std::string rejected_views(const ConstImageView& source, const ImageView& destination) {
  return rejection_of([&] { thin(Rule::guo_hall, source, destination); });
}

TEST(Thin, rejects_invalid_views) {
  ByteImage a = untouched(20, 10);
  ByteImage b = untouched(20, 11);
  EXPECT_EQ(rejected_views(a.view(), b.view()),
            "source is 20 x 10 and destination 20 x 11; they must have the same size");
  const ConstImageView from = a.view();
  const ImageView to = {b.view().data, 20, 10, b.view().stride};
  EXPECT_EQ(rejected_views({from.data, 20, 10, 19}, to),
            "source has a stride of 19 bytes, below its width of 20");
  EXPECT_EQ(rejected_views(from, {to.data, 20, 10, 19}),
            "destination has a stride of 19 bytes, below its width of 20");
  EXPECT_EQ(rejected_views({from.data, 20, -1, 64}, {to.data, 20, -1, 64}),
            "source has the size 20 x -1");
  EXPECT_EQ(rejected_views({from.data, -20, 1, 64}, to), "source has the size -20 x 1");
  EXPECT_EQ(rejected_views({nullptr, 20, 10, 64}, to), "source has no data");
  EXPECT_EQ(rejected_views(from, {nullptr, 20, 10, 64}), "destination has no data");
  constexpr Index huge = std::numeric_limits<Index>::max() / 2;
  EXPECT_EQ(rejected_views({from.data, 20, 10, huge}, to),
            "source exceeds the address space: 20 x 10, stride 4611686018427387903");
  EXPECT_TRUE(is_untouched(a.view()));
  EXPECT_TRUE(is_untouched(b.view()));
}

TEST(Thin, rejects_partial_overlap) {
  const std::string text = "source and destination overlap without being the same image";
  ByteImage buffer = untouched(40, 10);
  const Index stride = buffer.view().stride;
  std::uint8_t* data = buffer.view().data;
  EXPECT_EQ(rejected_views({data, 20, 8, stride}, {data, 20, 8, stride}), "") << "one image";
  buffer = untouched(40, 10);
  data = buffer.view().data;
  for (const Index distance : {Index{1}, Index{19}, stride - 19, stride + 19, 2 * stride}) {
    EXPECT_EQ(rejected_views({data, 20, 8, stride}, {data + distance, 20, 8, stride}), text)
        << distance;
    EXPECT_EQ(rejected_views({data + distance, 20, 8, stride}, {data, 20, 8, stride}), text)
        << distance;
  }
  EXPECT_EQ(rejected_views({data, 20, 4, stride}, {data, 20, 4, 2 * stride}), text)
      << "same first pixel, other strides";
  EXPECT_TRUE(is_untouched(buffer.view()));
}

/// The error that thin() and Thinner throw for these options; checks that nothing was written.
std::string rejected_options(const Rule& rule, const Thinning& thinning,
                             const Execution& execution = {}) {
  const ByteImage image = noise_image(60, 10, 80, 1, 5);
  ByteImage out = untouched(60, 10);
  const std::string text =
      rejection_of([&] { thin(rule, image.view(), out.view(), thinning, execution); });
  EXPECT_TRUE(is_one_sentence(text)) << text;
  EXPECT_TRUE(is_untouched(out.view())) << text;
  const std::string of_thinner = rejection_of([&] { Thinner(rule, 60, 10, thinning, execution); });
  EXPECT_EQ(of_thinner, text);
  return text;
}

TEST(Thin, rejects_numbers_out_of_range) {
  EXPECT_EQ(rejected_options(Rule::guo_hall, {}, {.threads = 0}),
            "threads: expected an integer in [1, 1024], got 0");
  EXPECT_EQ(rejected_options(Rule::guo_hall, {}, {.threads = -1}),
            "threads: expected an integer in [1, 1024], got -1");
  EXPECT_EQ(rejected_options(Rule::guo_hall, {}, {.threads = 1025}),
            "threads: expected an integer in [1, 1024], got 1025");
  for (const RuleInfo& info : kRules) {
    EXPECT_EQ(rejected_options(info.rule, {.max_iterations = 0}),
              "max_iterations: expected an integer of at least 1, got 0");
    EXPECT_EQ(rejected_options(info.rule, {.max_iterations = -1}),
              "max_iterations: expected an integer of at least 1, got -1");
  }
}

TEST(Enumerations, names_and_descriptions_of_values_outside_them_are_rejected) {
  const std::string end = ": expected one of the enumeration, got number 99";
  const auto rejection = [](auto ask) { return rejection_of([&] { static_cast<void>(ask()); }); };
  EXPECT_EQ(rejection([] { return rule_info(static_cast<BuiltInRule>(99)).name; }), "rule" + end);
  EXPECT_EQ(rejection([] { return rule_name(static_cast<BuiltInRule>(99)); }), "rule" + end);
  EXPECT_EQ(rejection([] { return border_name(static_cast<Border>(99)); }), "border" + end);
  EXPECT_EQ(rejection([] { return edge_operator_info(static_cast<EdgeOperator>(99)).name; }),
            "operator" + end);
}

TEST(Thin, rejects_invalid_enumerators) {
  const auto number = [](auto kind, int value) { return static_cast<decltype(kind)>(value); };
  for (const int value : {static_cast<int>(kRules.size()), 99, 255}) {
    EXPECT_EQ(rejection_of([&] { Rule(number(BuiltInRule{}, value)); }),
              "rule: expected one of the enumeration, got number " + std::to_string(value));
  }
  for (const int value : {static_cast<int>(Isa::neon_sha3) + 1, 99, 255}) {
    EXPECT_EQ(rejected_options(Rule::mb2, {}, {.isa = number(Isa{}, value)}),
              "isa: expected one of " + all_isa_names() + ", got number " + std::to_string(value));
  }
  for (const int value : {3, 99, 255}) {
    for (const RuleInfo& info : kRules) {
      EXPECT_EQ(rejected_options(info.rule, {.border = number(Border{}, value)}),
                "border: expected background, keep or foreground, got " + std::to_string(value));
    }
  }
  EXPECT_EQ(rejection_of([] { Rule(Directions{0x10}); }),
            "directions: expected bits in [0, 15], got 16");
}

bool has_row_kernel() {
  return best_isa() == Isa::avx512 || best_isa() == Isa::avx512icl;
}

TEST(Thin, error_for_a_missing_variant_lists_the_existing_instruction_sets) {
  EXPECT_EQ(rejected_options(Rule::spta, {}, {.isa = Isa::sse42}),
            "thin_spta at sse4.2 on one thread: its instruction sets are baseline");
}

TEST(Thinner, chooses_the_latest_isa_and_the_technique_by_width) {
  const Thinner narrow(Rule::naccache_shinghal, 100, 10);
  const Thinner wide(Rule::naccache_shinghal, 2000, 10);
  EXPECT_EQ(narrow.isa(), best_isa());
  EXPECT_EQ(wide.isa(), best_isa());
  EXPECT_EQ(narrow.technique(), has_row_kernel() ? "simd_bitpacked_row" : "simd_bitpacked_tiles");
  EXPECT_EQ(wide.technique(), "simd_bitpacked_tiles");
  const Thinner sequential(Rule::spta, 2000, 2000, {}, {.threads = 4});
  EXPECT_EQ(sequential.technique(), "bitpacked");
  EXPECT_EQ(sequential.isa(), Isa::baseline);
}

TEST(Thinner, reports_the_requested_isa) {
  const Thinner thinner(Rule::zhang_suen, 100, 10, {}, {.isa = Isa::baseline});
  EXPECT_EQ(thinner.isa(), Isa::baseline);
}

TEST(Thinner, gives_correct_results_on_repeated_use) {
  Thinner thinner(Rule::guo_hall, 90, 33, {.border = Border::keep, .max_iterations = 2});
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const ByteImage image = noise_image(90, 33, 30 * static_cast<int>(seed), 2, seed);
    const Thinned expected = thinned_by_reference(Rule::guo_hall, image, {Border::keep, 2});
    ByteImage out = untouched(90, 33);
    EXPECT_EQ(thinner(image.view(), out.view()), expected.iterations);
    EXPECT_TRUE(equal(out.view(), expected.image.view()));
  }
}

TEST(Thinner, works_after_moves) {
  static_assert(!std::is_copy_constructible_v<Thinner> && !std::is_copy_assignable_v<Thinner>);
  static_assert(std::is_nothrow_move_constructible_v<Thinner>);
  static_assert(std::is_nothrow_move_assignable_v<Thinner>);
  const ByteImage image = noise_image(60, 20, 90, 1, 4);
  const Thinned expected = thinned_by_reference(Rule::mb2, image);
  Thinner first(Rule::mb2, 60, 20);
  const std::string_view technique = first.technique();
  Thinner second(std::move(first));
  Thinner third(Rule::spta, 5, 5);
  third = std::move(second);
  EXPECT_EQ(third.technique(), technique);
  ByteImage out = untouched(60, 20);
  EXPECT_EQ(third(image.view(), out.view()), expected.iterations);
  EXPECT_TRUE(equal(out.view(), expected.image.view()));
}

TEST(Thinner, rejects_invalid_sizes) {
  const auto rejected = [](Index width, Index height) {
    return rejection_of([&] { Thinner(Rule::guo_hall, width, height); });
  };
  EXPECT_EQ(rejected(-1, 5), "image size -1 x 5 is negative");
  EXPECT_EQ(rejected(5, -1), "image size 5 x -1 is negative");
  EXPECT_EQ(rejected(Index{1} << 40, 2), "image size 1099511627776 x 2 is larger than 2^40 pixels");
  EXPECT_EQ(rejected(2, std::numeric_limits<Index>::max()),
            "image size 2 x 9223372036854775807 is larger than 2^40 pixels");
}

TEST(Thinner, rejects_images_of_another_size) {
  Thinner thinner(Rule::guo_hall, 28, 28);
  ByteImage image(28, 27);
  ByteImage out = untouched(28, 27);
  EXPECT_EQ(rejection_of([&] { thinner(image.view(), out.view()); }),
            "expected images of 28 x 28, got 28 x 27");
  EXPECT_TRUE(is_untouched(out.view()));
}

}  // namespace
}  // namespace thinbench
