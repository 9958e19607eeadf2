// The verification itself, which must detect and describe wrong variants; names of images.
#include "harness/verify.hpp"

#include <gtest/gtest.h>

#include "harness/families.hpp"
#include "harness/image_names.hpp"
#include "harness/test_images.hpp"
#include "measure/copy_operation.hpp"
#include "techniques/variants.hpp"

namespace thinbench {
namespace {

TEST(FindMismatch, names_the_first_wrong_pixel_and_prints_its_neighbourhood) {
  const ByteImage input = image_of_bits(5, 3, 0b00000'11111'00100);
  Copy job(true);
  const std::string text =
      find_mismatch(job, input.view(), {copy_of(input.view()), {}}).value_or("");
  EXPECT_NE(text.find("pixel (0, 0) is 255 instead of 0"), std::string::npos) << text;
  EXPECT_NE(text.find("  ..#..\n  #####\n"), std::string::npos) << text;
}

/// Copies its input. In its second run, whose buffers have guard bytes, it also does harm.
class CopyingJob final : public Copy {
 public:
  using Harm = void (*)(const ConstImageView& input, const ImageView& output);
  explicit CopyingJob(Harm harm) : Copy(false), harm_(harm) {}
  void run(const ConstImageView& input, const ImageView& output) override {
    Copy::run(input, output);
    if (++runs_ == 2) harm_(input, output);
  }

 private:
  Harm harm_;
  int runs_ = 0;
};

std::string mismatch_after(CopyingJob::Harm harm) {
  CopyingJob job(harm);
  const ByteImage input = noise_image(7, 5, 50, 1, 2);
  return find_mismatch(job, input.view(), {copy_of(input.view()), {}}).value_or("");
}

void change(const ConstImageView& input, Index offset) {
  ++const_cast<std::uint8_t*>(input.data)[offset];
}

TEST(FindMismatch, detects_a_changed_input) {
  EXPECT_EQ(mismatch_after([](const ConstImageView&, const ImageView&) {}), "");
  const CopyingJob::Harm harms[] = {
      [](const ConstImageView& input, const ImageView&) { change(input, 2 * input.stride + 3); },
      [](const ConstImageView& input, const ImageView&) { change(input, input.width); },
      [](const ConstImageView& input, const ImageView&) { change(input, -1); }};
  for (const auto harm : harms) EXPECT_EQ(mismatch_after(harm), "the input was changed");
}

TEST(FindMismatch, detects_writes_outside_the_destination) {
  const CopyingJob::Harm harms[] = {
      [](const ConstImageView&, const ImageView& output) { output.row(2)[output.width] = 0; },
      [](const ConstImageView&, const ImageView& output) { output.row(4)[-1] = 0; },
      [](const ConstImageView&, const ImageView& output) { output.row(-1)[3] = 0; },
      [](const ConstImageView&, const ImageView& output) { output.row(output.height)[0] = 0; }};
  for (const auto harm : harms) {
    EXPECT_EQ(mismatch_after(harm), "bytes beside the destination were changed");
  }
}

/// Gives a list of numbers and no image, like labelling.
class ListJob final : public Job {
 public:
  explicit ListJob(std::vector<std::int64_t> list) : list_(std::move(list)) {}
  void run(const ConstImageView&, const ImageView&) override {}
  [[nodiscard]] std::vector<std::int64_t> numbers() const override { return list_; }
  [[nodiscard]] bool gives_image() const override { return false; }

 private:
  std::vector<std::int64_t> list_;
};

TEST(FindMismatch, compares_lists_of_numbers) {
  ListJob job({4, 5, 6});
  const ByteImage input(5, 3);
  EXPECT_EQ(find_mismatch(job, input.view(), {{}, {4, 5, 6}}), std::nullopt);
  EXPECT_EQ(find_mismatch(job, input.view(), {{}, {4, 7, 6}}), "number 1: 5 instead of 7");
  EXPECT_EQ(find_mismatch(job, input.view(), {{}, {4, 5}}), "3 numbers instead of 2");
}

TEST(FindKernelMismatch, compares_the_result_of_the_kernel_alone) {
  const detail::ThinningOperation& operation = detail::thinning_operations().front();
  const ByteImage input = noise_image(40, 20, 80, 2, 6);
  const Outcome expected = expected_of(operation.name, input.view());
  const auto job = thinning_job(make_state(operation.variants.front(), 40, 20,
                                           detail::thinning_parameters(operation.key, {}), 1));
  EXPECT_EQ(find_kernel_mismatch(*job, input.view(), expected), std::nullopt);
  EXPECT_EQ(find_kernel_mismatch(*job, input.view(), {copy_of(expected.image.view()), {0}}),
            "iterations: " + std::to_string(expected.numbers[0]) + " instead of 0");
}

TEST(Job, without_a_separate_kernel_rejects_the_call) {
  ListJob job({});
  EXPECT_THROW(job.kernel(), std::logic_error);
}

TEST(ThinByReference, rejects_rules_without_a_reference) {
  ByteImage image(3, 3);
  const reference::Repetition outside_is_foreground = {Border::foreground};
  EXPECT_THROW(static_cast<void>(reference_named("no_such_rule")), std::logic_error);
  EXPECT_THROW(thin_by_reference(Rule::mb2, outside_is_foreground, image.view(), image.view()),
               std::logic_error);
}

TEST(Verifier, skips_variants_of_another_input_kind) {
  Verifier verifier(matching_rows("thin_naccache_shinghal/lut/", {2}));
  verifier.show({"grey", grey_noise_image(9, 9, 0, 255, 1), InputKind::grey});
  EXPECT_EQ(summary_of(verifier).skipped, static_cast<int>(verifier.rows().size()));
}

TEST(GreyImages, noise_has_every_level_of_its_range_and_no_other) {
  const ByteImage image = grey_noise_image(100, 100, 7, 40, 1);
  std::array<bool, 256> seen{};
  for (Index i = 0; i < 10000; ++i) seen[image.at(i % 100, i / 100)] = true;
  for (std::size_t level = 0; level < 256; ++level) {
    EXPECT_EQ(seen[level], level >= 7 && level <= 40) << level;
  }
}

TEST(MatchingRows, filters_by_name_and_repeats_threaded_variants_per_thread_count) {
  for (const Row& row : matching_rows("simd_bitpacked/.*/(2|7)$", {2, 7})) {
    EXPECT_TRUE(row.variant->threaded);
  }
  EXPECT_FALSE(matching_rows("simd_bitpacked/.*/7$", {2, 7}).empty());
  EXPECT_TRUE(matching_rows("no_such_row", {2}).empty());
}

TEST(MatchingRows, rejects_a_malformed_expression) {
  EXPECT_THROW(static_cast<void>(matching_rows("(", {1})), std::invalid_argument);
}

TEST(TestImages, neighbourhood_sheet_has_all_512_neighbourhoods) {
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

using Names = std::vector<std::string>;

std::string named(const std::string& path, const Names& taken = {}) {
  return image_name(path, taken, std::regex("scene|square_[0-9]+"));
}

TEST(ImageName, is_the_files_without_directory_and_ending) {
  EXPECT_EQ(named("a/b/horse.png"), "horse");
  EXPECT_EQ(named("horse.old.png"), "horse.old");
  EXPECT_EQ(named("horse"), "horse");
}

TEST(ImageName, gets_the_first_free_number) {
  EXPECT_EQ(named("horse.png", {"horse"}), "horse_2");
  EXPECT_EQ(named("horse.png", {"horse", "horse_2", "horse_4"}), "horse_3");
}

TEST(ImageName, is_never_reserved_with_and_without_a_number) {
  EXPECT_EQ(named("scene.png"), "scene_image");
  EXPECT_EQ(named("scene.png", {"scene_image"}), "scene_image_2");
  EXPECT_EQ(named("square.png"), "square");
  EXPECT_EQ(named("square.png", {"square"}), "square_image");
  EXPECT_EQ(named("square.png", {"square", "square_image"}), "square_image_2");
}

}  // namespace
}  // namespace thinbench
