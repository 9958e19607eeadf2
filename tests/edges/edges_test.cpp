// Every variant at thresholds beyond the defaults, the plan, and what the public edge refuses.
#include <gtest/gtest.h>

#include "harness/crosscheck.hpp"
#include "harness/edges_family.hpp"
#include "harness/grey_images.hpp"
#include "thinbench/edges.hpp"

namespace thinbench {
namespace {

constexpr std::string_view kSobel = "edges_sobel";

/// 0 left of column `at`, `height` from there on.
ByteImage step_image(Index at, std::uint8_t height) {
  ByteImage image(80, 12);
  for (Index y = 0; y < 12; ++y) {
    for (Index x = at; x < 80; ++x) image.at(x, y) = height;
  }
  return image;
}

TEST(EdgeThresholds, every_variant_equals_its_reference_at_every_kind) {
  const ByteImage image = grey_noise_image(199, 41, 0, 255, 3);
  for (const EdgeOperation& edges : edge_operations()) {
    for (const EdgeThresholds& thresholds :
         {EdgeThresholds{0, 0}, EdgeThresholds{1, 1}, EdgeThresholds{127, 127},
          EdgeThresholds{128, 254}, EdgeThresholds{255, 0}, EdgeThresholds{0, 255}}) {
      const Operation operation = edges_operation(edges, thresholds);
      for (const Variant& variant : operation.variants) {
        if (!variant.unavailable_reason(199).empty()) continue;
        const auto job = variant.make_job(199, 41, variant.threaded ? 3 : 1);
        EXPECT_EQ(find_mismatch(*job, image.view(), expected_of(operation, variant, image.view())),
                  std::nullopt)
            << operation.name << " " << variant.technique << " " << isa_name(variant.isa);
      }
    }
  }
}

TEST(EdgeScales, vertical_step_of_height_h_reads_h) {
  for (const EdgeOperation& operation : edge_operations()) {
    const ByteImage image = step_image(40, 100);
    ByteImage out(80, 12);
    detect_edges(operation.name, image.view(), out.view(), {99, 0});
    EXPECT_EQ(out.at(39, 6), 255) << operation.name;
    detect_edges(operation.name, image.view(), out.view(), {100, 0});
    for (Index x = 0; x < 80; ++x) EXPECT_EQ(out.at(x, 6), 0) << operation.name << " " << x;
  }
}

TEST(EdgeThresholds, second_one_asks_for_a_bright_pixel_beside_the_edge) {
  const ByteImage image = step_image(40, 100);
  ByteImage out(80, 12);
  detect_edges(kSobel, image.view(), out.view(), {10, 99});
  EXPECT_EQ(out.at(39, 6), 255);
  EXPECT_EQ(out.at(40, 6), 255);
  detect_edges(kSobel, image.view(), out.view(), {10, 100});
  EXPECT_EQ(out.at(39, 6), 0);
}

TEST(EdgeBorder, frame_is_no_edge_by_itself) {
  for (const EdgeOperation& operation : edge_operations()) {
    ByteImage image = step_image(0, 255);
    ByteImage out = grey_noise_image(80, 12, 0, 255, 1);
    detect_edges(operation.name, image.view(), out.view(), {0, 0});
    EXPECT_TRUE(equal(out.view(), ByteImage(80, 12).view())) << operation.name;
  }
}

TEST(EdgePlan, bits_hold_what_bytes_show) {
  const ByteImage image = grey_noise_image(131, 20, 0, 255, 5);
  const EdgeOperation& operation = *find_edge_operation(kSobel);
  const EdgeVariant& variant =
      choose_variant(operation, 131, {.technique = Technique::simd_to_bits, .isa = {}});
  EdgePlan plan(operation, variant, 131, 20);
  const ConstBitPlaneView bits = plan.run_to_bits(image.view());
  const Outcome expected = expected_of(kSobel, image.view());
  for (Index y = 0; y < 20; ++y) {
    for (Index x = 0; x < 131; ++x) {
      EXPECT_EQ(bits.row(y)[x / 64] >> (x % 64) & 1, expected.image.at(x, y) != 0 ? 1U : 0U);
    }
  }
  EXPECT_TRUE(plan.margins_are_zero());
}

TEST(EdgePlan, variants_of_bytes_have_no_bits) {
  const EdgeOperation& operation = *find_edge_operation(kSobel);
  EdgePlan plan(operation, operation.variants.front(), 10, 10);
  EXPECT_THROW(plan.run_to_bits(ByteImage(10, 10).view()), std::logic_error);
}

TEST(DetectEdges, default_choice_is_the_fastest_available) {
  const EdgeVariant& variant = choose_variant(*find_edge_operation(kSobel), 100);
  EXPECT_EQ(variant.facts.technique, Technique::simd_16bit);
  EXPECT_FALSE(variant.facts.threaded);
}

TEST(DetectEdges, empty_images_are_fine) {
  for (const auto& [width, height] : {std::pair<Index, Index>{0, 0}, {0, 5}, {5, 0}}) {
    ByteImage image(width, height);
    ByteImage out(width, height);
    for (const EdgeOperation& operation : edge_operations()) {
      EXPECT_NO_THROW(detect_edges(operation.name, image.view(), out.view()));
    }
  }
}

std::string refusal(const ConstImageView& source, const ImageView& destination,
                    const EdgeThresholds& thresholds = {}, std::string_view operation = kSobel,
                    int threads = 1) {
  try {
    detect_edges(operation, source, destination, thresholds, {.threads = threads});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(DetectEdges, refuses_what_it_cannot_do_and_says_why) {
  ByteImage a(20, 10);
  ByteImage b(20, 10);
  ByteImage c(20, 11);
  EXPECT_EQ(refusal(a.view(), c.view()),
            "source is 20 x 10 and destination 20 x 11; they must have one size");
  EXPECT_EQ(refusal(a.view(), a.view()), "source and destination overlap");
  EXPECT_EQ(refusal(a.view(), b.view(), {256, 0}), "p1 is 256; it must be in 0..255");
  EXPECT_EQ(refusal(a.view(), b.view(), {0, -1}), "p2 is -1; it must be in 0..255");
  EXPECT_EQ(refusal(a.view(), b.view(), {}, "edges_canny"),
            "no edge operation is named edges_canny");
  EXPECT_EQ(refusal(a.view(), b.view(), {}, kSobel, 0), "threads is 0; it must be in 1..1024");
  EXPECT_EQ(refusal(a.view(), b.view()), "");
}

TEST(DetectEdges, refuses_views_that_are_no_images_or_overlap_in_part) {
  ByteImage a(20, 10);
  ByteImage b(20, 10);
  const ImageView to = b.view();
  EXPECT_EQ(refusal({nullptr, 20, 10, 64}, to), "source has no data");
  EXPECT_EQ(refusal(a.view(), {nullptr, 20, 10, 64}), "destination has no data");
  EXPECT_EQ(refusal({a.view().data, 20, 10, 19}, to),
            "source has a stride of 19 bytes, below its width of 20");
  EXPECT_EQ(refusal({a.view().data, -1, 10, 64}, to), "source has the size -1 x 10");
  ByteImage both(50, 12);
  const ImageView view = both.view();
  EXPECT_EQ(refusal({view.data, 20, 10, view.stride}, {view.row(2) + 3, 20, 10, view.stride}),
            "source and destination overlap");
  EXPECT_EQ(refusal({view.data, 20, 10, view.stride}, {view.data + 25, 20, 10, view.stride}), "")
      << "side by side";
}

TEST(DetectEdges, refuses_what_there_is_not_and_lists_what_there_is) {
  const auto refusal_of = [](const Options& wish) -> std::string {
    try {
      static_cast<void>(choose_variant(*find_edge_operation(kSobel), 100, wish));
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const std::string none = ": there is no such variant; ";
  EXPECT_EQ(refusal_of({Technique::union_find, {}, 1}),
            "edges_sobel by union_find at any instruction set on one thread" + none +
                "its techniques are lut, autovec, simd_16bit, simd_to_bits");
  EXPECT_EQ(
      refusal_of({Technique::lut, Isa::avx2, 1}),
      "edges_sobel by lut at avx2 on one thread" + none + "its instruction sets are baseline");
  EXPECT_EQ(refusal_of({Technique::autovec, {}, 2}),
            "edges_sobel by autovec at any instruction set with threads" + none +
                "it runs on one thread only");
}

}  // namespace
}  // namespace thinbench
