// The public edge: what it chooses and what it refuses.
#include <algorithm>

#include <gtest/gtest.h>

#include "harness/operation.hpp"
#include "harness/test_images.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

constexpr std::string_view kOperation = "thin_naccache_shinghal";

std::string refusal(const ConstImageView& source, const ImageView& destination,
                    const Options& options = {}, std::string_view operation = kOperation) {
  try {
    thin(operation, source, destination, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Thin, default_choice_equals_the_reference_at_any_width) {
  for (const Index width : {1, 64, 510, 512, 513, 1100}) {
    const ByteImage image = noise_image(width, 40, 95, 1, 2);
    const Outcome expected = expected_of(kOperation, image.view());
    for (const int threads : {1, 3}) {
      ByteImage out(width, 40);
      EXPECT_EQ(thin(kOperation, image.view(), out.view(), {.threads = threads}),
                expected.numbers[0]);
      EXPECT_TRUE(equal(out.view(), expected.image.view()));
    }
  }
}

TEST(Thin, empty_images_take_one_pass) {
  ByteImage empty(0, 0);
  EXPECT_EQ(thin(kOperation, empty.view(), empty.view()), 1);
}

TEST(ChooseVariant, takes_the_highest_available_level) {
  const auto& operation = *find_thinning_operation(kOperation);
  EXPECT_EQ(choose_variant(operation, 2000).isa, best_isa());
  EXPECT_EQ(choose_variant(operation, 2000).technique, Technique::simd_bitpacked_tiles);
}

TEST(ChooseVariant, follows_the_options) {
  const auto& operation = *find_thinning_operation(kOperation);
  const auto& variant =
      choose_variant(operation, 100, {.technique = Technique::lut, .isa = {}, .threads = 2});
  EXPECT_EQ(variant.technique, Technique::lut);
  EXPECT_TRUE(variant.threaded);
}

int worthwhile(const Options& options, Index width, Index height) {
  return worthwhile_threads(*find_thinning_operation(kOperation), options, width, height);
}

TEST(WorthwhileThreads, small_images_get_one_unless_a_technique_is_asked_for) {
  EXPECT_EQ(worthwhile({.threads = 4}, 510, 412), 1);
  EXPECT_EQ(worthwhile({.threads = 4}, 1024, 1024), 4);
  EXPECT_EQ(worthwhile({.technique = Technique::bitpacked, .threads = 4}, 510, 412), 4);
  EXPECT_EQ(worthwhile({.threads = 0}, 510, 412), 0) << "refused later, by its value";
  EXPECT_EQ(worthwhile({.threads = 5000}, 510, 412), 5000) << "refused later, too";
  EXPECT_EQ(worthwhile({.threads = 4}, Index{1} << 40, 0), 1);
  EXPECT_EQ(worthwhile({.threads = 4}, Index{1} << 19, Index{1} << 44), 4);
}

TEST(WorthwhileThreads, an_operation_that_no_technique_shares_gets_one) {
  const ThinningOperation& alone = *find_thinning_operation("thin_spta");
  EXPECT_EQ(worthwhile_threads(alone, {.threads = 4}, 2000, 2000), 1);
  const ByteImage image(1100, 1000);
  ByteImage out(1100, 1000);
  EXPECT_EQ(thin("thin_spta", image.view(), out.view(), {.threads = 4}), 1);
}

TEST(ChooseVariant, names_what_does_not_exist) {
  const auto& operation = *find_thinning_operation(kOperation);
  try {
    static_cast<void>(
        choose_variant(operation, 100, {.technique = Technique::lut, .isa = Isa::avx2}));
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "thin_naccache_shinghal by lut at avx2 on one thread: there is no such variant; "
                 "its instruction sets are baseline");
  }
}

TEST(Thin, refuses_bad_views_and_says_why) {
  ByteImage a(20, 10);
  ByteImage b(20, 11);
  EXPECT_EQ(refusal(a.view(), b.view()),
            "source is 20 x 10 and destination 20 x 11; they must have one size");
  ImageView narrow = a.view();
  narrow.stride = 19;
  EXPECT_EQ(refusal(narrow, narrow), "source has a stride of 19 bytes, below its width of 20");
  ImageView negative = a.view();
  negative.height = -1;
  EXPECT_EQ(refusal(negative, negative), "source has the size 20 x -1");
  ImageView null = a.view();
  null.data = nullptr;
  EXPECT_EQ(refusal(null, a.view()), "source has no data");
  ImageView huge = a.view();
  huge.stride = PTRDIFF_MAX / 2;
  EXPECT_NE(refusal(huge, huge).find("more memory than there is"), std::string::npos);
}

TEST(Thin, refuses_partial_overlap) {
  ByteImage image(20, 10);
  ImageView upper = image.view();
  upper.height = 8;
  ImageView lower = upper;
  lower.data = image.view().row(2);
  EXPECT_EQ(refusal(upper, lower), "source and destination overlap without being the same image");
}

TEST(Thin, takes_views_of_one_buffer_that_lie_side_by_side) {
  const ByteImage image = noise_image(20, 10, 90, 1, 3);
  const Outcome expected = expected_of(kOperation, image.view());
  for (const Index first : {0, 20}) {  // the source's column; the destination takes the other half
    ByteImage buffer(40, 10);
    const ImageView source{buffer.view().data + first, 20, 10, buffer.view().stride};
    const ImageView destination{buffer.view().data + 20 - first, 20, 10, buffer.view().stride};
    for (Index y = 0; y < 10; ++y) std::copy_n(image.view().row(y), 20, source.row(y));
    EXPECT_EQ(refusal(source, destination), "");
    EXPECT_TRUE(equal(destination, expected.image.view()));
    EXPECT_TRUE(equal(source, image.view()));
  }
}

TEST(Thin, refuses_views_whose_columns_meet) {
  ByteImage buffer(40, 10);
  const Index stride = buffer.view().stride;
  const ImageView left{buffer.view().data, 20, 9, stride};
  const std::string text = "source and destination overlap without being the same image";
  for (const Index apart : {Index{1}, Index{19}, stride - 19, stride + 19, 2 * stride}) {
    const ImageView other{buffer.view().data + apart, 20, 8, stride};
    EXPECT_EQ(refusal({left.data, 20, 8, stride}, other), text) << apart;
    EXPECT_EQ(refusal(other, {left.data, 20, 8, stride}), text) << apart;
  }
}

TEST(Thin, refuses_unknown_operations_and_thread_counts) {
  ByteImage a(5, 5);
  EXPECT_EQ(refusal(a.view(), a.view(), {}, "thin_zhang"), "no operation is named thin_zhang");
  EXPECT_EQ(refusal(a.view(), a.view(), {.threads = 0}), "threads is 0; it must be in 1..1024");
}

}  // namespace
}  // namespace thinbench
