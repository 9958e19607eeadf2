// The catalogue of operations, and the choice of a variant from it.
#include "api/catalogue.hpp"

#include <set>
#include <string_view>

#include <gtest/gtest.h>

namespace thinbench::detail {
namespace {

const ThinningOperation& parallel_operation() {
  return operation_of(Rule::naccache_shinghal);
}

TEST(Catalogue, lists_every_enumerator_at_its_index) {
  for (std::size_t i = 0; i < kRules.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kRules[i].rule), i);
    EXPECT_EQ(thinning_operations()[i].rule, kRules[i].rule);
    EXPECT_EQ(&operation_of(kRules[i].rule), &thinning_operations()[i]);
  }
  EXPECT_EQ(thinning_operations().size(), kRules.size());
  for (std::size_t i = 0; i < kEdgeOperators.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kEdgeOperators[i].op), i);
    EXPECT_EQ(edge_operations()[i].op, kEdgeOperators[i].op);
  }
  for (std::size_t i = 0; i < kTechniques.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kTechniques[i].technique), i);
  }
}

TEST(Catalogue, names_are_unique_and_map_to_their_enumerators) {
  std::set<std::string_view> names;
  for (const RuleInfo& info : kRules) {
    EXPECT_TRUE(names.insert(info.operation).second) << info.operation;
    EXPECT_EQ(rule_from_name(info.name), info.rule);
    EXPECT_EQ(rule_from_name(info.operation), info.rule);
  }
  for (const EdgeOperatorInfo& info : kEdgeOperators) {
    EXPECT_TRUE(names.insert(info.operation).second) << info.operation;
    EXPECT_EQ(edge_operator_from_name(info.name), info.op);
    EXPECT_EQ(edge_operator_from_name(info.operation), info.op);
  }
  for (const RegionsOperation& operation : regions_operations()) {
    EXPECT_TRUE(names.insert(operation.name).second) << operation.name;
  }
  EXPECT_TRUE(names.insert(localise_operation().name).second);
  for (const TechniqueInfo& info : kTechniques) {
    EXPECT_EQ(technique_from_name(info.name), info.technique);
  }
  EXPECT_EQ(rule_from_name("thin_zhang"), std::nullopt);
  EXPECT_EQ(edge_operator_from_name("canny"), std::nullopt);
  EXPECT_EQ(technique_from_name("magic"), std::nullopt);
}

template <class Operation>
void expect_valid_variants(const Operation& operation) {
  std::set<std::tuple<Technique, Isa, bool>> seen;
  bool runs_anywhere = false;
  for (const auto& variant : operation.variants) {
    EXPECT_TRUE(seen.insert({variant.technique, variant.isa, variant.threaded}).second)
        << operation.name << " by " << technique_name(variant.technique) << " twice";
    EXPECT_NE(variant.make, nullptr);
    const bool any_image = variant.max_width == kAnyWidth && variant.keeps_border;
    runs_anywhere =
        runs_anywhere || (variant.isa == Isa::baseline && !variant.threaded && any_image);
  }
  EXPECT_TRUE(runs_anywhere) << operation.name;
}

TEST(Catalogue, every_operation_has_unique_variants_and_one_for_any_machine_and_image) {
  for (const ThinningOperation& operation : thinning_operations()) expect_valid_variants(operation);
  for (const EdgeOperation& operation : edge_operations()) expect_valid_variants(operation);
  for (const RegionsOperation& operation : regions_operations()) expect_valid_variants(operation);
  expect_valid_variants(localise_operation());
}

int useful_threads(const Options& options, Index width, Index height, bool can_share = true) {
  return with_useful_threads(options, can_share, width, height).threads;
}

TEST(UsefulThreads, small_images_use_one_thread_unless_a_technique_is_requested) {
  const Options four = {.threads = 4};
  EXPECT_EQ(useful_threads(four, 510, 412), 1);
  EXPECT_EQ(useful_threads(four, 1024, 1023), 1);
  EXPECT_EQ(useful_threads(four, 1024, 1024), 4);
  EXPECT_EQ(useful_threads({.threads = 4, .technique = Technique::bitpacked}, 510, 412), 4);
  EXPECT_EQ(useful_threads(four, Index{1} << 40, 0), 1);
  EXPECT_EQ(useful_threads(four, Index{1} << 19, Index{1} << 44), 4);
}

TEST(UsefulThreads, operations_without_a_threaded_variant_use_one_thread) {
  EXPECT_EQ(useful_threads({.threads = 4}, 2000, 2000, false), 1);
  EXPECT_FALSE(choose(operation_of(Rule::spta), 2000, 2000, {.threads = 4}).threaded);
}

TEST(UsefulThreads, numbers_out_of_range_are_rejected) {
  EXPECT_THROW(useful_threads({.threads = 0}, 5, 5), std::invalid_argument);
  EXPECT_THROW(useful_threads({.threads = kMaxThreads + 1}, 5, 5), std::invalid_argument);
}

TEST(Choose, takes_the_highest_priority_which_is_the_latest_isa) {
  for (const ThinningOperation& operation : thinning_operations()) {
    const ThinningVariant& chosen = choose(operation, 2000, 500, {});
    for (const ThinningVariant& other : operation.variants) {
      if (other.threaded || !unavailable_reason(other, 2000).empty()) continue;
      EXPECT_LE(other.priority, chosen.priority) << operation.name;
    }
  }
  EXPECT_EQ(choose(parallel_operation(), 2000, 500, {}).isa, best_isa());
  EXPECT_EQ(choose(parallel_operation(), 2000, 500, {}).technique, Technique::simd_bitpacked_tiles);
}

TEST(Choose, takes_the_requested_technique_threads_and_isa) {
  const ThinningVariant& variant =
      choose(parallel_operation(), 100, 10, {.threads = 2, .technique = Technique::lut});
  EXPECT_EQ(variant.technique, Technique::lut);
  EXPECT_TRUE(variant.threaded);
  EXPECT_EQ(choose(parallel_operation(), 100, 10, {.isa = Isa::baseline}).isa, Isa::baseline);
}

}  // namespace
}  // namespace thinbench::detail
