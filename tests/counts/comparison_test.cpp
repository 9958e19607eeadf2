#include "counts/comparison.hpp"

#include <gtest/gtest.h>

#include "counts/documents.hpp"
#include "counts/row_counts.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

Json document(const std::string& row, std::uint64_t instructions) {
  return {{"schema", kCountsSchema},
          {"kind", "instructions"},
          {"valgrind", "3.19.0"},
          {"build", build_json()},
          {"input", {{"name", "scene_small"}}},
          {"max_steps", 5000},
          {"rows", {{{"row", row}, {"instructions", instructions}, {"method", "single_steps"}}}},
          {"skipped", Json::array()}};
}

TEST(Comparison, one_percent_more_is_the_same_and_two_are_more) {
  const Json before = document("a", 1000);
  EXPECT_EQ(to_text(compare(before, document("a", 1010))),
            "1 rows compared: 0 take more instructions, 0 fewer (tolerance 1 %)\n");
  EXPECT_EQ(compare(before, document("a", 1020)).more(), 1U);
  EXPECT_EQ(to_text(compare(before, document("a", 1020))),
            "a: 1000 instructions before, 1020 now (+2.0 %)\n"
            "1 rows compared: 1 take more instructions, 0 fewer (tolerance 1 %)\n");
}

TEST(Comparison, fewer_instructions_are_told_and_no_failure) {
  const Comparison comparison = compare(document("a", 1000), document("a", 900));
  EXPECT_EQ(comparison.moved.size(), 1U);
  EXPECT_EQ(comparison.more(), 0U);
}

TEST(Comparison, a_row_that_became_too_long_to_be_counted_takes_more) {
  Json now = document("b", 1);
  now["skipped"].push_back({{"row", "a"}, {"reason", kTooManySteps}});
  EXPECT_EQ(compare(document("a", 1000), now).more(), 1U);
  EXPECT_EQ(compare(document("a", 6000), now).compared, 0U);  // it was counted with more steps
}

Json of_iterations(Json document, int iterations) {
  document["rows"][0]["iterations"] = iterations;
  return document;
}

TEST(Comparison, another_number_of_iterations_fails_whatever_instructions_say) {
  const Json before = of_iterations(document("a", 1000), 7);
  EXPECT_FALSE(compare(before, before).fails());
  EXPECT_FALSE(compare(document("a", 1000), before).fails());  // not stored then
  const Comparison fewer = compare(before, of_iterations(document("a", 900), 6));
  EXPECT_TRUE(fewer.fails());
  EXPECT_EQ(to_text(fewer),
            "a: 1000 instructions before, 900 now (-10.0 %)\n"
            "a: 7 iterations before, 6 now\n"
            "1 rows compared: 0 take more instructions, 1 fewer (tolerance 1 %)\n");
}

Json by_callgrind(Json document) {
  document["rows"][0]["method"] = "callgrind";
  return document;
}

TEST(Comparison, rows_counted_by_another_method_or_valgrind_are_not_compared_and_reported) {
  const Json stepped = document("a", 1000);
  const Json counted = by_callgrind(document("a", 2000));
  EXPECT_EQ(to_text(compare(stepped, counted)),
            "1 rows not compared: they were counted by another method or valgrind\n"
            "0 rows compared: 0 take more instructions, 0 fewer (tolerance 1 %)\n");
  EXPECT_EQ(compare(counted, counted).compared, 1U);
  Json other = counted;
  other["valgrind"] = "3.20.0";
  EXPECT_EQ(compare(counted, other).otherwise_counted, 1U);
}

TEST(Comparison, rows_without_callgrind_now_have_not_become_too_long) {
  Json now = document("b", 1);
  now["skipped"].push_back({{"row", "a"}, {"reason", kTooManySteps}});
  const Comparison comparison = compare(by_callgrind(document("a", 1000)), now);
  EXPECT_EQ(comparison.compared, 0U);
  EXPECT_EQ(comparison.otherwise_counted, 1U);
}

TEST(Comparison, another_compiler_or_input_or_no_row_in_common_compares_nothing) {
  Json other = document("a", 1000);
  other["build"]["compiler"]["version"] = "1";
  EXPECT_EQ(to_text(compare(other, document("a", 1000))),
            "nothing compared: they are of another compiler\n");
  other = document("a", 1000);
  other["input"]["name"] = "else";
  EXPECT_EQ(compare(other, document("a", 1000)).why_not, "they are of another input");
  EXPECT_EQ(compare(document("b", 1000), document("a", 1000)).compared, 0U);
}

std::string rejection_of(const std::string& file) {
  try {
    static_cast<void>(read_counts(file));
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(Comparison, files_that_hold_no_counts_are_rejected_by_name) {
  const TemporaryDirectory directory;
  EXPECT_EQ(rejection_of("absent.json"), "cannot read 'absent.json': there is no such file");
  const std::string cut = directory.with("cut.json", R"({"schema": 1,)");
  EXPECT_EQ(rejection_of(cut), "'" + cut + "' is not complete JSON");
  for (const char* text : {"[]", "{}", R"({"schema": 3})", R"({"schema": 1, "rows": [7]})"}) {
    const std::string file = directory.with("x.json", text);
    EXPECT_EQ(rejection_of(file), "'" + file + "' holds no counts that this version knows") << text;
  }
  const std::string good = directory.with("good.json", document("a", 1).dump());
  EXPECT_EQ(read_counts(good).at("rows").size(), 1U);
}

TEST(Comparison, files_whose_parts_have_wrong_types_are_rejected_before_they_are_compared) {
  const TemporaryDirectory directory;
  const char* const patches[] = {
      R"({"skipped": null})", R"({"skipped": [{"row": 7, "reason": ""}]})",
      R"({"skipped": [{"row": "a"}]})", R"({"max_steps": "many"})",
      R"({"rows": [{"row": "a", "method": "", "instructions": 1e300}]})"};
  for (const char* patch : patches) {
    Json damaged = document("a", 1);
    damaged.merge_patch(Json::parse(patch));
    const std::string file = directory.with("x.json", damaged.dump());
    EXPECT_EQ(rejection_of(file), "'" + file + "' holds no counts that this version knows")
        << patch;
  }
}

}  // namespace
}  // namespace thinbench
