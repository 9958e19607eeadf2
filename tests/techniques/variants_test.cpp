// The lists of all operations with their variants, and the choice that the product makes from them.
#include "techniques/variants.hpp"

#include <set>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "localise/state.hpp"
#include "regions/state.hpp"
#include "support/variant_of.hpp"
#include "techniques/passes.hpp"

namespace thinbench::detail {
namespace {

TEST(Catalogue, lists_every_enumerator_at_its_index) {
  for (std::size_t i = 0; i < kRules.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kRules[i].rule), i);
    EXPECT_EQ(study::thinning_operations()[i].key.name(), kRules[i].name);
    EXPECT_EQ(&study::operation_of(kRules[i].rule), &study::thinning_operations()[i]);
  }
  for (std::size_t i = 0; i < study::kStudyRules.size(); ++i) {
    const study::StudyRuleInfo& info = study::kStudyRules[i];
    EXPECT_EQ(static_cast<std::size_t>(info.rule), i);
    EXPECT_EQ(study::operation_of(info.rule).key.name(), info.name);
  }
  EXPECT_EQ(study::thinning_operations().size(), kRules.size() + study::kStudyRules.size());
  for (std::size_t i = 0; i < kEdgeOperators.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kEdgeOperators[i].op), i);
    EXPECT_EQ(study::edge_operations()[i].key, kEdgeOperators[i].op);
  }
}

TEST(Catalogue, names_are_unique_and_map_to_their_enumerators) {
  std::set<std::string_view> names;
  for (const RuleInfo& info : kRules) {
    EXPECT_TRUE(names.insert(info.operation).second) << info.operation;
    EXPECT_EQ(rule_from_name(info.name), info.rule);
    EXPECT_EQ(rule_from_name(info.operation), info.rule);
  }
  for (const study::StudyRuleInfo& info : study::kStudyRules) {
    EXPECT_TRUE(names.insert(info.operation).second) << info.operation;
    EXPECT_EQ(rule_from_name(info.name), std::nullopt);
  }
  for (const EdgeOperatorInfo& info : kEdgeOperators) {
    EXPECT_TRUE(names.insert(info.operation).second) << info.operation;
    EXPECT_EQ(edge_operator_from_name(info.name), info.op);
    EXPECT_EQ(edge_operator_from_name(info.operation), info.op);
  }
  for (const auto& operation : list_operations()) EXPECT_TRUE(names.insert(operation.name).second);
  for (const auto& operation : label_operations()) EXPECT_TRUE(names.insert(operation.name).second);
  for (const auto& operation : euler_operations()) EXPECT_TRUE(names.insert(operation.name).second);
  for (const auto& operation : fill_operations()) EXPECT_TRUE(names.insert(operation.name).second);
  EXPECT_TRUE(names.insert(localise_operation().name).second);
  EXPECT_EQ(rule_from_name("thin_zhang"), std::nullopt);
  EXPECT_EQ(edge_operator_from_name("canny"), std::nullopt);
}

template <class Operation>
void expect_valid_variants(const Operation& operation) {
  std::set<std::tuple<std::string_view, Isa, bool>> seen;
  bool runs_anywhere = false;
  for (const auto& variant : operation.variants) {
    EXPECT_TRUE(seen.insert({variant.technique, variant.isa, variant.threaded}).second)
        << operation.name << " by " << variant.technique << " twice";
    EXPECT_EQ(study::technique_info(variant.technique).name, variant.technique);
    EXPECT_NE(variant.make, nullptr);
    runs_anywhere = runs_anywhere || (variant.isa == Isa::baseline && !variant.threaded &&
                                      variant.max_width == kAnyWidth);
  }
  EXPECT_TRUE(runs_anywhere) << operation.name;
}

/// The product's variants are the last of the study's.
template <class Operation>
void expect_extended(const Operation& product, const Operation& study) {
  EXPECT_EQ(product.name, study.name);
  expect_valid_variants(product);
  expect_valid_variants(study);
  const std::size_t added = study.variants.size() - product.variants.size();
  for (std::size_t i = 0; i < product.variants.size(); ++i) {
    EXPECT_EQ(product.variants[i].make, study.variants[added + i].make) << product.name;
  }
}

/// The study may have more operations behind those of the product.
template <class Operations>
void expect_all_extended(const Operations& product, const Operations& study) {
  ASSERT_LE(product.size(), study.size());
  for (std::size_t i = product.size(); i < study.size(); ++i) expect_valid_variants(study[i]);
  for (std::size_t i = 0; i < product.size(); ++i) expect_extended(product[i], study[i]);
}

TEST(Catalogue, every_operation_has_unique_variants_and_one_for_any_machine_and_image) {
  expect_all_extended(thinning_operations(), study::thinning_operations());
  expect_all_extended(edge_operations(), study::edge_operations());
  for (const auto& operation : list_operations()) expect_valid_variants(operation);
  for (const auto& operation : label_operations()) expect_valid_variants(operation);
  for (const auto& operation : euler_operations()) expect_valid_variants(operation);
  for (const auto& operation : fill_operations()) expect_valid_variants(operation);
  expect_extended(distance_operation(), study::distance_operation());
  expect_extended(graph_operation(), study::graph_operation());
  expect_extended(midpoint_operation(), study::midpoint_operation());
  expect_valid_variants(localise_operation());
}

TEST(Catalogue, rejects_techniques_without_a_description) {
  EXPECT_THROW(static_cast<void>(study::technique_info("magic")), std::logic_error);
}

TEST(ChooseThinning, takes_the_highest_priority_which_is_the_latest_isa) {
  for (const ThinningOperation& operation : study::thinning_operations().first(kRules.size())) {
    const ThinningVariant& chosen = chosen_variant(operation.key, 2000, 500);
    for (const ThinningVariant& other : operation.variants) {
      if (other.threaded || !unavailable_reason(other, 2000).empty()) continue;
      EXPECT_LE(other.priority, chosen.priority) << operation.name;
    }
  }
}

TEST(ChooseThinning, takes_the_requested_isa) {
  const Execution baseline = {.isa = Isa::baseline};
  EXPECT_EQ(chosen_variant(Rule::naccache_shinghal, 100, 10, baseline).isa, Isa::baseline);
  const ThinningVariant& any = chosen_variant(Rule::naccache_shinghal, 2000, 500);
  EXPECT_EQ(any.isa, best_isa());
  EXPECT_EQ(any.technique, "simd_bitpacked_tiles");
}

TEST(ForEachRun, visits_runs_of_columns_clipped_to_the_row_and_collects_changes) {
  using Visits = std::vector<std::pair<Index, std::uint64_t>>;
  Visits seen;
  const std::uint64_t changed =
      for_each_run(Band{2, 4, 0b1011, 10, 36}, [&](Index y, Index from, Index to) {
        seen.emplace_back(y, static_cast<std::uint64_t>(100 * from + to));
        return from == 30;
      });
  EXPECT_EQ(seen, (Visits{{2, 20}, {3, 20}, {2, 3036}, {3, 3036}}));
  EXPECT_EQ(changed, 0b1000U);
}

}  // namespace
}  // namespace thinbench::detail
