#include <set>

#include <gtest/gtest.h>

#include "measure/copy_operation.hpp"
#include "measure/timed_call.hpp"
#include "measure/timed_row.hpp"
#include "support/usage.hpp"

namespace thinbench {
namespace {

using Names = std::vector<std::string>;

Names names_of(const std::vector<TimedRow>& rows) {
  Names names;
  for (const TimedRow& row : rows) names.push_back(row.name);
  return names;
}

class SelectRows : public testing::Test {
 protected:
  std::vector<Operation> operations = copy_operations();
  std::vector<TimedInput> inputs = timed_inputs({});
};

TEST_F(SelectRows, rows_that_differ_from_the_reference_or_cannot_run_are_omitted_and_reported) {
  const Selection selection = select_rows({}, operations, inputs);
  EXPECT_EQ(names_of(selection.rows), (Names{"copy/reference/baseline/1/end_to_end/scene",
                                             "copy/good/baseline/1/end_to_end/scene"}));
  ASSERT_EQ(selection.mismatches.size(), 1U);
  EXPECT_EQ(selection.mismatches[0].find("copy/bad/baseline/1/scene: pixel (0, 0) is 255"), 0U)
      << selection.mismatches[0];
  EXPECT_EQ(selection.verified, 1);
  ASSERT_EQ(selection.skipped.size(), 1U);
  EXPECT_EQ(selection.skipped[0].name, "copy/absent/baseline/1/scene");
  EXPECT_EQ(selection.skipped[0].reason, "this machine lacks it");
}

TEST_F(SelectRows, reference_comes_along_with_any_row_and_nothing_else_does) {
  const Selection selection = select_rows({.filter = "copy/good/"}, operations, inputs);
  EXPECT_EQ(selection.rows.size(), 2U);
  EXPECT_TRUE(selection.mismatches.empty());
  EXPECT_TRUE(select_rows({.filter = "no_such_row"}, operations, inputs).rows.empty());
}

TEST_F(SelectRows, highest_takes_one_isa_of_each_technique_and_on_small_images_one_thread) {
  operations = {operation_of("thin_naccache_shinghal")};
  const std::string filter = "simd_bitpacked/.*/end_to_end|simd_bitpacked_row/.*/end_to_end";
  const Selection selection = select_rows({filter, VariantChoice::highest}, operations, inputs);
  std::set<std::string> techniques;
  for (const TimedRow& row : selection.rows) {
    if (row.variant == nullptr) continue;
    EXPECT_TRUE(techniques.insert(std::string(row.variant->technique)).second) << row.name;
    EXPECT_EQ(row.variant->isa, best_isa()) << row.name;
    EXPECT_EQ(row.threads, 1) << row.name;
  }
  EXPECT_FALSE(techniques.empty());
}

/// "technique/isa" of the library's variants that a choice takes, threads aside.
std::set<std::string> chosen(VariantChoice choice, const std::vector<TimedInput>& inputs) {
  const std::vector<Operation> operations = {operation_of("edges_sobel")};
  std::set<std::string> names;
  for (const TimedRow& row : select_rows({"", choice}, operations, inputs).rows) {
    if (row.variant == nullptr) continue;
    names.insert(std::string(row.variant->technique) + "/" + std::string(row.variant->isa_label()));
  }
  return names;
}

TEST_F(SelectRows, usual_takes_each_technique_once_and_the_best_of_each_isa_on_one_thread) {
  std::set<std::string> isas;
  std::set<std::string> techniques;
  operations = {operation_of("edges_sobel")};
  for (const TimedRow& row : select_rows({"", VariantChoice::usual}, operations, inputs).rows) {
    if (row.variant == nullptr || row.is_peer()) continue;
    EXPECT_EQ(row.threads, 1) << row.name;  // the scene is too small for threads
    isas.insert(std::string(row.variant->isa_label()));
    techniques.insert(std::string(row.variant->technique));
    const bool chosen_by_library = is_default(*row.operation, *row.variant, 510);
    EXPECT_TRUE(row.scope == Scope::end_to_end || chosen_by_library) << row.name;
  }
  for (const std::string& name : chosen(VariantChoice::all, inputs)) {
    EXPECT_EQ(techniques.count(name.substr(0, name.find('/'))), 1U) << name;
    EXPECT_EQ(isas.count(name.substr(name.find('/') + 1)), 1U) << name;
  }
}

TEST_F(SelectRows, usual_takes_threads_where_the_library_does) {
  operations = {operation_of("edges_sobel")};
  inputs = timed_inputs({{}, {}, {"square_1024"}});
  int threaded = 0;
  for (const TimedRow& row : select_rows({"", VariantChoice::usual}, operations, inputs).rows) {
    if (row.threads == 1) continue;
    ++threaded;
    EXPECT_TRUE(is_default(*row.operation, *row.variant, 1024)) << row.name;
  }
  EXPECT_EQ(threaded, 1);
}

TEST_F(SelectRows, best_takes_the_variant_of_the_highest_priority_and_the_best_scalar_one) {
  operations.front().variants.clear();
  for (const char* technique : {"autovec", "lut", "bitpacked", "simd_bytes"}) {
    operations.front().variants.push_back(copy_variant(technique, false));
    operations.front().variants.back().priority = static_cast<int>(operations[0].variants.size());
  }
  const Selection selection = select_rows({"", VariantChoice::best}, operations, inputs);
  EXPECT_EQ(names_of(selection.rows), (Names{"copy/reference/baseline/1/end_to_end/scene",
                                             "copy/bitpacked/baseline/1/end_to_end/scene",
                                             "copy/simd_bytes/baseline/1/end_to_end/scene"}));
}

TEST_F(SelectRows, rows_are_found_again_by_their_names) {
  operations = {operation_of("thin_guo_hall")};
  for (const TimedRow& row : select_rows({.filter = "bitpacked/"}, operations, inputs).rows) {
    const TimedRow found = row_named(row.name, operations, inputs);
    EXPECT_EQ(found.variant, row.variant) << row.name;
    EXPECT_EQ(found.threads, row.threads) << row.name;
    EXPECT_EQ(found.scope, row.scope) << row.name;
  }
  EXPECT_THROW(
      static_cast<void>(row_named("thin_guo_hall/x/avx2/1/kernel/scene", operations, inputs)),
      std::runtime_error);
}

/// The cases of the rows that a filter selects.
std::set<std::string> cases_of(const std::string& filter, const std::vector<TimedInput>& inputs) {
  std::set<std::string> cases;
  for (const TimedRow& row : select_rows({.filter = filter}, all_operations(), inputs).rows) {
    cases.insert(row.operation->name);
  }
  return cases;
}

TEST_F(SelectRows, cases_without_a_peer_are_selected_where_the_filter_spells_them_out) {
  using Cases = std::set<std::string>;
  EXPECT_EQ(cases_of("(mb2|guo_hall)(:keep)?/bitpacked/baseline/1/end_to_end", inputs),
            (Cases{"thin_guo_hall", "thin_guo_hall:keep", "thin_mb2"}));
  EXPECT_EQ(cases_of("^(thin_mb2:keep|holes)/.*/baseline/1/end_to_end", inputs),
            (Cases{"holes", "thin_mb2:keep"}));
  EXPECT_EQ(cases_of("^net_two_layer_linear:keep:1/lut/baseline/1/end_to_end", inputs),
            (Cases{"net_two_layer_linear:keep:1"}));
}

TEST_F(SelectRows, why_there_is_no_row_is_explained) {
  const auto explanation = [&](const RowChoice& choice) {
    try {
      static_cast<void>(select_rows_or_explain(choice, operations, inputs));
    } catch (const UsageError& error) {
      return std::string(error.what());
    }
    return std::string("rows");
  };
  EXPECT_EQ(explanation({.filter = "nothing"}),
            "no row matches the filter 'nothing'; see 'thinbench-study list --variants'");
  EXPECT_EQ(explanation({.filter = "copy/absent/"}),
            "every row that matches the filter 'copy/absent/' is skipped: this machine lacks it");
  EXPECT_EQ(explanation({.filter = "copy/(absent|reference)/"}), "rows");
  EXPECT_EQ(explanation({.filter = "copy/bad/"}), "rows") << "the mismatch was reported";
  EXPECT_EQ(explanation({.filter = "("}).rfind("--filter: '(' is not a regular expression", 0), 0U);
  operations = {operation_of("edges_sobel")};
  EXPECT_EQ(
      explanation({"simd_16bit/.*/kernel/|/2/", VariantChoice::usual}).rfind("no usual row", 0),
      0U);
}

TEST(Rows, every_row_has_a_name_of_its_own) {
  std::set<std::string> names;
  for (const Row& row : matching_rows("", {2, 7})) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_EQ(std::count(row.name.begin(), row.name.end(), '/'), 3) << row.name;
  }
  EXPECT_GT(names.size(), 100U);
}

TEST_F(SelectRows, kernels_that_give_numbers_alone_have_an_outcome_too) {
  const Selection selection = select_rows(
      {.filter = "^(holes|objects|euler_number)/(bitpacked|union).*/1/"}, all_operations(), inputs);
  ASSERT_FALSE(selection.rows.empty());
  for (const TimedRow& row : selection.rows) {
    TimedCall call(row);
    call();
    EXPECT_FALSE(call.outcome().numbers.empty()) << row.name;
  }
}

}  // namespace
}  // namespace thinbench
