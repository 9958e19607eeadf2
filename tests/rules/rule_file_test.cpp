// Custom rules from files: every kind of table, defaults, errors.
#include "rules/rule_file.hpp"

#include <bit>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/own_directory.hpp"
#include "support/rejection.hpp"
#include "thinbench/named_rules.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

const WindowTable kLife = table_from_hensel("B3/S23");

/// A text with this table as its only one.
std::string with_table(const Json& table) {
  return Json{{"sub_iterations", Json::array({table})}}.dump();
}

WindowTable only_table(const Json& table) {
  const RuleDescription rule = parse_rule(with_table(table), "rule.json");
  EXPECT_EQ(rule.sub_iterations.size(), 1U);
  return rule.sub_iterations.front();
}

std::string binary_of(const WindowTable& table) {
  std::string text;
  for (std::size_t window = 0; window < 512; ++window) text += table[window] ? '1' : '0';
  return text;
}

std::string hexadecimal_of(const WindowTable& table, const char* digits) {
  std::string text;
  for (std::size_t window = 0; window < 512; window += 4) {
    const int value =
        8 * table[window] + 4 * table[window + 1] + 2 * table[window + 2] + 1 * table[window + 3];
    text += digits[value];
  }
  return text;
}

TEST(RuleFile, defaults) {
  const RuleDescription rule = parse_rule(R"({"hensel": "B3/S23"})", "some/where/life.json");
  EXPECT_EQ(rule.name, "life");
  EXPECT_EQ(rule.sub_iterations, std::vector{kLife});
  EXPECT_EQ(rule.border, Border::background);
  EXPECT_EQ(rule.max_iterations, kUnlimited);
}

TEST(RuleFile, options) {
  const RuleDescription rule = parse_rule(
      R"({"hensel": "B3/S23", "name": "Conway's", "border": "foreground", "max_iterations": 7})",
      "rule.json");
  EXPECT_EQ(rule.name, "Conway's");
  EXPECT_EQ(rule.border, Border::foreground);
  EXPECT_EQ(rule.max_iterations, 7);
  EXPECT_EQ(parse_rule(R"({"hensel": "B/S", "border": "keep"})", "").border, Border::keep);
}

TEST(RuleFile, raster_tables_read_back) {
  for (const NamedRule& rule : named_rules()) {
    for (const WindowTable& table : rule.sub_iterations) {
      EXPECT_EQ(only_table({{"raster", binary_of(table)}}), table);
      EXPECT_EQ(only_table({{"raster", hexadecimal_of(table, "0123456789abcdef")}}), table);
      EXPECT_EQ(only_table({{"raster", hexadecimal_of(table, "0123456789ABCDEF")}}), table);
    }
  }
}

TEST(RuleFile, tables_in_other_orders_and_notations) {
  std::vector<std::uint8_t> values(512);
  for (std::size_t i = 0; i < 512; ++i) values[i] = static_cast<std::uint8_t>(std::popcount(i) % 2);
  values[1] = 0;
  EXPECT_EQ(only_table({{"makelut", values}, {"order", "matlab"}}),
            table_from_values(values, WindowOrder::matlab));
  EXPECT_EQ(only_table({{"makelut", values}, {"order", "octave"}}),
            table_from_values(values, WindowOrder::octave));
  const std::vector<std::uint8_t> removed(values.begin(), values.begin() + 256);
  EXPECT_EQ(only_table({{"remove", removed}, {"order", "descriptor"}}),
            table_from_removals(removed, kDescriptorOrder));
  EXPECT_EQ(only_table({{"remove", removed}, {"order", "clockwise"}}),
            table_from_removals(removed, kClockwiseOrder));
  EXPECT_EQ(only_table({{"remove", removed}, {"order", "raster"}}),
            table_from_removals(removed, kRasterOrder));
  EXPECT_EQ(only_table({{"hensel", "b3s23"}}), kLife);
  const std::vector<std::string> patterns = {"4:(... .1. .0.)->0", "M:(1.. ... ...)->1"};
  EXPECT_EQ(only_table({{"patterns", patterns}}), table_from_patterns(patterns));
}

TEST(RuleFile, values_may_be_truth_values) {
  std::vector<bool> values(512);
  values[511] = true;
  EXPECT_EQ(only_table({{"makelut", values}, {"order", "matlab"}}),
            find_named_rule("erode")->sub_iterations.front());
}

TEST(RuleFile, sub_iterations_keep_their_order) {
  const RuleDescription rule = parse_rule(
      R"({"sub_iterations": [{"hensel": "B3/S23"}, {"hensel": "B/S"}, {"hensel": "B3/S23"}]})", "");
  EXPECT_EQ(rule.sub_iterations, (std::vector{kLife, WindowTable(), kLife}));
}

using Errors = std::vector<std::pair<std::string, std::string>>;

/// Texts and what is wrong with them, after the name of the file.
void expect_errors(const Errors& errors) {
  for (const auto& [text, expected] : errors) {
    EXPECT_EQ(
        rejection_of<std::runtime_error>([&, json = text] { (void)parse_rule(json, "rule.json"); }),
        "rule.json: " + expected)
        << text.substr(0, 200);
  }
}

TEST(RuleFile, errors_of_structure_and_options_name_the_key) {
  const std::string limits = "max_iterations must lie between 1 and 2147483647";
  const std::string name = "name must have 1 to 100 bytes without control characters";
  expect_errors({
      {"", "not JSON, or truncated, at byte 0 of 0"},
      {R"({"hensel": "B3/S23")", "not JSON, or truncated, at byte 19 of 19"},
      {"[]", "the outermost value must be an object"},
      {"{}", "the outermost value must have either sub_iterations or hensel"},
      {R"({"hensel": "B/S", "sub_iterations": []})",
       "the outermost value must have either sub_iterations or hensel"},
      {R"({"hensel": "B/S", "colour": 1})", R"(the outermost value has the unknown key "colour")"},
      {R"({"hensel": "B/S", "hensel": "B/S"})", R"(the key "hensel" is repeated)"},
      {R"({"sub_iterations": [{"hensel": "B/S"}, {"raster": 1, "raster": 2}]})",
       R"(the key "raster" is repeated)"},
      {std::string(16, '[') + std::string(16, ']'), "the outermost value must be an object"},
      {std::string(17, '[') + std::string(17, ']'), "values are nested too deep"},
      {std::string(900000, '['), "values are nested too deep"},
      {R"({"hensel": "B/S", "max_iterations": 1e999})", "a number is too large to read"},
      {R"({"hensel": "B/S", "border": "reflect"})",
       R"(border must be "background", "keep" or "foreground")"},
      {R"({"hensel": "B/S", "border": 1})", "border must be a text"},
      {R"({"hensel": "B/S", "max_iterations": 0})", limits},
      {R"({"hensel": "B/S", "max_iterations": 2147483648})", limits},
      {R"({"hensel": "B/S", "max_iterations": 1.5})", "max_iterations must be an integer"},
      {R"({"hensel": "B/S", "name": ""})", name},
      {R"({"hensel": "B/S", "name": "a\nb"})", name},
  });
}

TEST(RuleFile, errors_of_tables_name_their_place) {
  std::vector<int> values(512);
  std::vector<int> with_2 = values;
  with_2[17] = 2;
  const std::string first = "sub_iterations[0]";
  expect_errors({
      {R"({"sub_iterations": []})", "sub_iterations has 0 tables; it must have 1 to 8"},
      {R"({"sub_iterations": {}})", "sub_iterations must be a list"},
      {R"({"sub_iterations": [1,2,3,4,5,6,7,8,9]})",
       "sub_iterations has 9 tables; it must have 1 to 8"},
      {with_table(5), first + " must be an object"},
      {with_table(Json::object()),
       first + " must have raster, makelut, remove, patterns or hensel"},
      {with_table({{"raster", "01"}, {"hensel", "B/S"}}),
       first + R"( has the unknown key "hensel")"},
      {with_table({{"hensel", "B9/S"}}),
       first + ".hensel is invalid: rule 'B9/S', column 2: expected a digit from 0 to 8, got '9'"},
      {with_table({{"patterns", Json::array({"4:(...)->1"})}}),
       first + ".patterns is invalid: pattern 1 '4:(...)->1', column 7: expected a pixel (0, 1, "
               "'.' or X), nine in all, got ')'"},
      {with_table({{"patterns", Json::array()}}),
       first + ".patterns has 0 patterns; it must have 1 to 1000"},
      {with_table({{"makelut", values}}), first + ".order is missing"},
      {with_table({{"makelut", values}, {"order", "raster"}}),
       first + R"(.order must be "matlab" or "octave")"},
      {with_table({{"remove", values}, {"order", "matlab"}}),
       first + R"(.order must be "descriptor", "clockwise" or "raster")"},
      {with_table({{"remove", values}, {"order", "raster"}}),
       first + ".remove has 512 values; it must have 256"},
      {with_table({{"makelut", with_2}, {"order", "matlab"}}),
       first + ".makelut[17] must be 0 or 1"},
      {with_table({{"raster", std::string(511, '0')}}),
       first + ".raster has 511 characters; it must have 512 digits 0 and 1 or 128 hexadecimal "
               "digits"},
      {with_table({{"raster", std::string(511, '0') + "2"}}),
       first + ".raster has no digit 0 or 1 at position 512"},
      {with_table({{"raster", "g" + std::string(127, '0')}}),
       first + ".raster has no digit 0 to 9 or a to f at position 1"},
  });
}

using RuleFiles = OwnDirectory;

TEST_F(RuleFiles, what_is_written_reads_back) {
  const std::string file = "rule.json";
  for (const NamedRule& named : named_rules()) {
    const RuleDescription rule = {std::string(named.name),
                                  {named.sub_iterations.begin(), named.sub_iterations.end()},
                                  named.border,
                                  named.max_iterations};
    write_rule_file(file, rule);
    const RuleDescription again = read_rule_file(file);
    EXPECT_EQ(again.name, rule.name);
    EXPECT_EQ(again.sub_iterations, rule.sub_iterations) << rule.name;
    EXPECT_EQ(again.border, rule.border) << rule.name;
    EXPECT_EQ(again.max_iterations, rule.max_iterations) << rule.name;
  }
}

}  // namespace
}  // namespace thinbench
