// detect_edges().
#include "thinbench/edges.hpp"

#include <cstdint>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "reference.hpp"
#include "support/filled_image.hpp"
#include "support/isa_parameters.hpp"
#include "support/rejection.hpp"

namespace thinbench {
namespace {

constexpr std::uint8_t kUntouched = 0x5A;

ByteImage untouched(Index width, Index height) {
  return filled_image(width, height, kUntouched);
}

bool is_untouched(const ByteImage& image) {
  return is_filled(image.view(), kUntouched);
}

TEST(DetectEdges, equals_the_reference_by_default) {
  for (const EdgeOperatorInfo& info : kEdgeOperators) {
    for (const Index width : {1, 7, 64, 200, 513}) {
      const ByteImage image = grey_noise_image(width, 21, 60, 200, 3);
      ByteImage expected(width, 21);
      reference::edges(info.op)({}, image.view(), expected.view());
      for (const int threads : {1, 3}) {
        ByteImage found = untouched(width, 21);
        detect_edges(info.op, image.view(), found.view(), {}, {.threads = threads});
        EXPECT_TRUE(equal(found.view(), expected.view())) << info.name << ", " << width;
      }
    }
  }
}

TEST(DetectEdges, accepts_images_without_pixels) {
  for (const auto& [width, height] : {std::pair<Index, Index>{0, 0}, {0, 5}, {5, 0}}) {
    for (const EdgeOperatorInfo& info : kEdgeOperators) {
      EXPECT_NO_THROW(detect_edges(info.op, {nullptr, width, height}, {nullptr, width, height}));
    }
  }
}

std::string rejected_views(const ConstImageView& source, const ImageView& destination) {
  return rejection_of([&] { detect_edges(EdgeOperator::sobel, source, destination); });
}

TEST(DetectEdges, rejects_invalid_views_and_any_overlap) {
  ByteImage a = untouched(20, 10);
  ByteImage b = untouched(20, 10);
  ByteImage c = untouched(20, 11);
  const ConstImageView from = a.view();
  const ImageView to = b.view();
  EXPECT_EQ(rejected_views(from, c.view()),
            "source is 20 x 10 and destination 20 x 11; they must have the same size");
  EXPECT_EQ(rejected_views(from, a.view()), "source and destination overlap");
  EXPECT_EQ(rejected_views({nullptr, 20, 10, 64}, to), "source has no data");
  EXPECT_EQ(rejected_views(from, {nullptr, 20, 10, 64}), "destination has no data");
  EXPECT_EQ(rejected_views({from.data, 20, 10, 19}, to),
            "source has a stride of 19 bytes, below its width of 20");
  EXPECT_EQ(rejected_views({from.data, -1, 10, 64}, to), "source has the size -1 x 10");
  EXPECT_TRUE(is_untouched(a) && is_untouched(b) && is_untouched(c));
  ByteImage both = untouched(50, 12);
  const ImageView view = both.view();
  const ConstImageView left = {view.data, 20, 10, view.stride};
  EXPECT_EQ(rejected_views(left, {view.row(2) + 3, 20, 10, view.stride}),
            "source and destination overlap");
  EXPECT_TRUE(is_untouched(both));
  EXPECT_EQ(rejected_views(left, {view.data + 25, 20, 10, view.stride}), "") << "side by side";
}

std::string rejected(const EdgeThresholds& thresholds, const Execution& execution = {},
                     EdgeOperator op = EdgeOperator::sobel) {
  const ByteImage image = grey_noise_image(20, 10, 0, 255, 3);
  ByteImage out = untouched(20, 10);
  const std::string text =
      rejection_of([&] { detect_edges(op, image.view(), out.view(), thresholds, execution); });
  EXPECT_TRUE(is_one_sentence(text)) << text;
  EXPECT_TRUE(is_untouched(out));
  return text;
}

TEST(DetectEdges, rejects_thresholds_out_of_range) {
  const std::string range = ": expected an integer in [0, 255], got ";
  EXPECT_EQ(rejected({256, 0}), "gradient_threshold" + range + "256");
  EXPECT_EQ(rejected({-1, 0}), "gradient_threshold" + range + "-1");
  EXPECT_EQ(rejected({0, 256}), "brightness_threshold" + range + "256");
  EXPECT_EQ(rejected({0, -1}), "brightness_threshold" + range + "-1");
}

TEST(DetectEdges, rejects_invalid_enumerators) {
  EXPECT_EQ(rejected({}, {}, static_cast<EdgeOperator>(6)),
            "operator: expected one of the enumeration, got number 6");
  EXPECT_EQ(rejected({}, {.isa = static_cast<Isa>(99)}),
            "isa: expected one of " + all_isa_names() + ", got number 99");
}

TEST(DetectEdges, rejects_unsuitable_options) {
  EXPECT_EQ(rejected({}, {.threads = 0}), "threads: expected an integer in [1, 1024], got 0");
  if (all_isas().back() == Isa::avx512icl) {
    EXPECT_EQ(rejected({}, {.isa = Isa::avx512icl}),
              "edges_sobel at avx512icl on one thread: its instruction sets are baseline, sse4.2, "
              "avx2, avx512");
  }
}

}  // namespace
}  // namespace thinbench
