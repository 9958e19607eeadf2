// The proof itself is put to the test: a wrong variant must be caught and named.
#include "harness/verify.hpp"

#include <gtest/gtest.h>

namespace thinbench {
namespace {

/// Copies its input and forgets one pixel.
std::uint64_t forgetful_pass(const RuleModel*, const ConstBytePlaneView& source,
                             const BytePlaneView& target, const Band& band) {
  for (Index y = band.first; y < band.last; ++y) {
    for (Index x = 0; x < source.width; ++x) target.row(y)[x] = source.row(y)[x];
  }
  if (band.first == 0 && source.width > 2) target.row(0)[2] = 0;
  return 0;
}

/// Writes one byte after the row.
std::uint64_t overrunning_pass(const RuleModel*, const ConstBytePlaneView& source,
                               const BytePlaneView& target, const Band& band) {
  for (Index y = band.first; y < band.last; ++y) {
    for (Index x = 0; x < source.width; ++x) target.row(y)[x] = source.row(y)[x];
    target.row(y)[source.row_elements] = 1;
  }
  return 0;
}

std::string mismatch_of(Pass<std::uint8_t> pass, const ConstByteView& input, Expected expected) {
  const std::array passes = {pass};
  const ThinningVariant variant{Technique::kLut, Isa::kBaseline, false, 1000,
                                std::span<const Pass<std::uint8_t>>(passes)};
  const ThinningOperation operation{"copy", "for tests", std::span(&variant, 1)};
  ThinningPlan plan(operation, variant, input.width, input.height);
  return find_mismatch(plan, input, expected).value_or("");
}

TEST(FindMismatch, names_the_first_wrong_pixel_and_shows_a_window) {
  const ByteImage input = image_of_bits(5, 3, 0b00000'11111'00100);
  Expected expected{copy_of(input.view()), 1};
  const std::string text = mismatch_of(&forgetful_pass, input.view(), std::move(expected));
  EXPECT_NE(text.find("pixel (2, 0) is 0 instead of 255"), std::string::npos) << text;
  EXPECT_NE(text.find("  ..#..\n  #####\n"), std::string::npos) << text;
}

TEST(FindMismatch, notices_a_wrong_number_of_passes) {
  const ByteImage input(5, 3);
  const std::string text = mismatch_of(&forgetful_pass, input.view(), {copy_of(input.view()), 3});
  EXPECT_EQ(text, "passes: 1 instead of 3");
}

TEST(FindMismatch, notices_a_write_into_the_margin) {
  const ByteImage input(5, 3);
  const std::string text = mismatch_of(&overrunning_pass, input.view(), {copy_of(input.view()), 1});
  EXPECT_EQ(text, "the margin of a plane was changed");
}

TEST(MatchingRows, filters_by_name_and_repeats_threaded_rows) {
  for (const Row& row : matching_rows("simd_bitpacked/.*/(2|7)$", {2, 7})) {
    EXPECT_TRUE(row.variant->threaded);
  }
  EXPECT_FALSE(matching_rows("simd_bitpacked/.*/7$", {2, 7}).empty());
  EXPECT_TRUE(matching_rows("no_such_row", {2}).empty());
}

TEST(MatchingRows, refuses_a_malformed_expression) {
  EXPECT_THROW(static_cast<void>(matching_rows("(", {1})), std::invalid_argument);
}

TEST(TestImages, sheet_holds_all_512_neighbourhoods) {
  const ByteImage sheet = neighbourhood_sheet(5);
  std::array<bool, 512> seen{};
  for (Index y = 1; y + 1 < sheet.height(); ++y) {
    for (Index x = 1; x + 1 < sheet.width(); ++x) {
      std::size_t code = 0;
      for (Index i = 0; i < 9; ++i) {
        code |= std::size_t{sheet.at(x - 1 + i % 3, y - 1 + i / 3) != 0} << i;
      }
      seen[code] = true;
    }
  }
  for (std::size_t code = 0; code < seen.size(); ++code) EXPECT_TRUE(seen[code]) << code;
}

}  // namespace
}  // namespace thinbench
