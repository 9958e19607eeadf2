// Images in files, thinned by tiles: equal to thin() in memory.
#include "out_of_core/out_of_core.hpp"

#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "compile/rule_body.hpp"
#include "harness/test_images.hpp"
#include "out_of_core/packed_files.hpp"
#include "support/made_image.hpp"
#include "support/rejection.hpp"
#include "support/rule_parameters.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

using Names = std::set<std::string>;

bool runs_on_tiles(const RuleAndBorder& tested) {
  const detail::RuleBody& rule = *tested.rule.body();
  return rule.kind == detail::RuleKind::parallel && !rule.adds_pixels() &&
         tested.border != Border::foreground;
}

std::vector<RuleAndBorder> rules_for_tiles() {
  std::vector<RuleAndBorder> rules = rules_and_borders();
  std::erase_if(rules, [](const RuleAndBorder& tested) { return !runs_on_tiles(tested); });
  return rules;
}

class OutOfCore : public testing::TestWithParam<RuleAndBorder> {
 protected:
  [[nodiscard]] static OutOfCoreRun tested(std::optional<int> max_iterations = std::nullopt) {
    const auto& [name, rule, border] = GetParam();
    return {.rule = rule, .thinning = {border, max_iterations}};
  }
};

/// Thins by tiles and in memory, and compares pixels, iterations and counts.
void expect_equal_to_thin(const ByteImage& image, OutOfCoreRun options, int iterations,
                          BitOrder order = BitOrder::msb_first) {
  const PackedImage source(image.view(), order);
  PackedImage expected(image.width(), image.height(), order);
  const int expected_iterations =
      thin(options.rule, source.view(), expected.view(), options.thinning);
  options.tiling = small_tiles(options.rule, source.view(), iterations);
  const PreparedRun prepared(source, options);
  const OutOfCoreResult result = thin_out_of_core(prepared.run);
  EXPECT_EQ(result.iterations, expected_iterations) << iterations << " per pass";
  EXPECT_EQ(result.foreground_before, packed_foreground(source.view()));
  EXPECT_EQ(result.foreground_after, packed_foreground(expected.view()));
  EXPECT_TRUE(prepared.result() == raw_bytes(expected)) << iterations << " per pass";
  EXPECT_EQ(prepared.directory.names(), (Names{"in", "out"}));
}

TEST_P(OutOfCore, equals_thin_on_noise_of_odd_widths) {
  std::uint64_t seed = 0;
  for (const Index width : {1, 127, 300}) {
    for (const Index granularity : {2, 20}) {
      const ByteImage image = noise_image(width, 150, 75, granularity, ++seed);
      const BitOrder order = seed % 2 == 0 ? BitOrder::msb_first : BitOrder::lsb_first;
      for (const int iterations : {1, 4}) {
        expect_equal_to_thin(image, tested(), iterations, order);
      }
    }
  }
}

TEST_P(OutOfCore, stops_after_the_maximum_number_of_iterations) {
  const ByteImage image = noise_image(200, 100, 85, 12, 5);
  for (const int max_iterations : {1, 2, 3, 4, 7, 12}) {
    expect_equal_to_thin(image, tested(max_iterations), 3);
  }
}

TEST_P(OutOfCore, works_on_processors_without_tiles_for_the_rule) {
  OutOfCoreRun run = tested();
  run.execution.isa = Isa::baseline;
  expect_equal_to_thin(noise_image(200, 100, 85, 12, 5), run, 3);
}

INSTANTIATE_TEST_SUITE_P(Rules, OutOfCore, testing::ValuesIn(rules_for_tiles()),
                         rule_and_border_test_name);

TEST(OutOfCore, counts_the_iterations_of_a_long_last_pass) {
  // One thick bar among thin ones: its tile changes long after all others.
  const ByteImage image = image_by(500, 100, [](Index x, Index y) {
    return y % 8 < 3 || (x > 220 && x < 258 && y > 20 && y < 90) ? 255 : 0;
  });
  for (const int iterations : {2, 7, 15, 16, 30}) {
    expect_equal_to_thin(image, {.rule = Rule::guo_hall}, iterations);
  }
}

TEST(OutOfCore, single_tile_and_several_threads_give_the_same) {
  const PackedImage source(noise_image(700, 500, 80, 9, 8).view(), BitOrder::msb_first);
  PackedImage expected(700, 500, BitOrder::msb_first);
  const int iterations = thin(Rule::mb2, source.view(), expected.view());
  for (const int threads : {1, 3}) {
    for (const Index bytes : {1 << 11, 1 << 20}) {
      OutOfCoreRun options{.rule = Rule::mb2, .execution = {.threads = threads}};
      options.tiling = tiling_for(700, 500, 2, bytes);
      const PreparedRun prepared(source, options);
      EXPECT_EQ(thin_out_of_core(prepared.run).iterations, iterations) << bytes;
      EXPECT_TRUE(prepared.result() == raw_bytes(expected)) << bytes;
    }
  }
}

PreparedRun prepared_noise(const OutOfCoreRun& options) {
  const PackedImage source(noise_image(150, 90, 80, 9, 8).view(), BitOrder::msb_first);
  OutOfCoreRun run = options;
  run.tiling = {150, 90, 64, 32, 8, 2};
  return {source, run};
}

/// A run that must fail with these words, and leave nothing.
void expect_run_rejected(const PreparedRun& prepared, const std::string& part) {
  const std::string error = rejection_of<std::exception>([&] { thin_out_of_core(prepared.run); });
  EXPECT_NE(error.find(part), std::string::npos) << error;
  EXPECT_TRUE(is_one_sentence(error)) << error;
  EXPECT_EQ(prepared.directory.names(), Names{"in"});
}

TEST(OutOfCore, rules_without_a_bounded_reach_and_those_that_add_pixels_are_rejected) {
  const auto expect_rule_rejected = [](const Rule& rule, const Thinning& thinning,
                                       const std::string& reason) {
    expect_run_rejected(prepared_noise({.rule = rule, .thinning = thinning}),
                        " cannot run on tiles; only rules that " + reason);
  };
  for (const Rule& rule : {Rule(Rule::spta), Rule(Rule::midpoint_scan), Rule(Directions{3})}) {
    expect_rule_rejected(rule, {}, "compute all pixels of a sub-iteration from the same image");
  }
  for (const Rule& rule : {Rule::named("dilate"), Rule::named("majority"), adding_rule()}) {
    expect_rule_rejected(rule, {}, "add no pixels");
  }
  for (const Rule& rule : {Rule(Rule::guo_hall), Rule::named("dilate")}) {
    expect_rule_rejected(rule, {Border::foreground}, "add no pixels");
  }
}

TEST(OutOfCore, what_cannot_be_read_or_written_is_reported_before_the_work) {
  PreparedRun prepared = prepared_noise({.rule = Rule::guo_hall});
  prepared.run.format.height = 91;
  expect_run_rejected(prepared, "in': it has 1710 bytes; 150 x 91 pixels take 1729");
  prepared.run.format = {Index{1} << 30, Index{1} << 30};
  expect_run_rejected(prepared, "the work files need 288230376151.7 MB");
  prepared.run.out = prepared.directory.file("none/out");
  expect_run_rejected(prepared, "none/out': there is no directory '");
}

TEST(OutOfCore, second_run_for_the_same_output_is_rejected) {
  PreparedRun prepared = prepared_noise({.rule = Rule::guo_hall});
  const OutOfCoreRun second = prepared.run;
  std::set<std::string> errors;
  prepared.run.on_tile = [&](int, Index) {
    errors.insert(rejection_of<FileError>([&] { thin_out_of_core(second); }));
  };
  thin_out_of_core(prepared.run);
  EXPECT_EQ(errors, Names{"cannot write '" + prepared.run.out + "': another run is writing it"});
}

}  // namespace
}  // namespace thinbench
