// Custom rules from files: every kind of table, defaults, errors.
#include "rules/rule_file.hpp"

#include <bit>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "support/temporary_directory.hpp"
#include "support/whole_file.hpp"
#include "thinbench/named_rules.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

const WindowTable kLife = table_from_hensel("B3/S23");

/// The error's line, or "accepted".
std::string error_of(const std::string& text) {
  try {
    (void)parse_rule(text, "rule.json");
    return "accepted";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

std::string error_of_file(const std::string& path) {
  try {
    (void)read_rule_file(path);
    return "accepted";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

/// The error of a rule with this table.
std::string error_of_table(const Json& table) {
  return error_of(Json{{"sub_iterations", Json::array({table})}}.dump());
}

WindowTable only_table(const Json& table) {
  const RuleDescription rule =
      parse_rule(Json{{"sub_iterations", Json::array({table})}}.dump(), "rule.json");
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

TEST(RuleFile, errors_of_structure) {
  EXPECT_EQ(error_of(""), "rule.json: not JSON, or truncated, at byte 1 of 0");
  EXPECT_EQ(error_of(R"({"hensel": "B3/S23")"),
            "rule.json: not JSON, or truncated, at byte 20 of 19");
  EXPECT_EQ(error_of("[]"), "rule.json: the outermost value must be an object");
  EXPECT_EQ(error_of("{}"),
            "rule.json: the outermost value must have either sub_iterations or hensel");
  EXPECT_EQ(error_of(R"({"hensel": "B/S", "sub_iterations": []})"),
            "rule.json: the outermost value must have either sub_iterations or hensel");
  EXPECT_EQ(error_of(R"({"hensel": "B/S", "colour": 1})"),
            R"(rule.json: the outermost value has the unknown key "colour")");
  EXPECT_EQ(error_of(R"({"hensel": "B/S", "hensel": "B/S"})"),
            R"(rule.json: the key "hensel" is repeated)");
  EXPECT_EQ(error_of(R"({"sub_iterations": [{"hensel": "B/S"}, {"raster": 1, "raster": 2}]})"),
            R"(rule.json: the key "raster" is repeated)");
  EXPECT_EQ(error_of(std::string(16, '[') + std::string(16, ']')),
            "rule.json: the outermost value must be an object");
  EXPECT_EQ(error_of(std::string(17, '[') + std::string(17, ']')),
            "rule.json: values are nested too deep");
  EXPECT_EQ(error_of(std::string(900000, '[')), "rule.json: values are nested too deep");
  EXPECT_EQ(error_of(R"({"hensel": "B/S", "max_iterations": 1e999})"),
            "rule.json: a number is too large to read");
}

TEST(RuleFile, errors_of_options) {
  const auto error = [](const std::string& field) {
    return error_of(R"({"hensel": "B/S", )" + field + "}");
  };
  EXPECT_EQ(error(R"("border": "reflect")"),
            R"(rule.json: border must be "background", "keep" or "foreground")");
  EXPECT_EQ(error(R"("border": 1)"), "rule.json: border must be a text");
  EXPECT_EQ(error(R"("max_iterations": 0)"),
            "rule.json: max_iterations must lie between 1 and 2147483647");
  EXPECT_EQ(error(R"("max_iterations": 2147483648)"),
            "rule.json: max_iterations must lie between 1 and 2147483647");
  EXPECT_EQ(error(R"("max_iterations": 1.5)"), "rule.json: max_iterations must be an integer");
  for (const char* name : {R"("name": "")", R"("name": "a\nb")"}) {
    EXPECT_EQ(error(name), "rule.json: name must have 1 to 100 bytes without control characters");
  }
}

TEST(RuleFile, errors_of_tables) {
  EXPECT_EQ(error_of(R"({"sub_iterations": []})"),
            "rule.json: sub_iterations has 0 tables; it must have 1 to 8");
  EXPECT_EQ(error_of(R"({"sub_iterations": {}})"), "rule.json: sub_iterations must be a list");
  EXPECT_EQ(error_of(R"({"sub_iterations": [1,2,3,4,5,6,7,8,9]})"),
            "rule.json: sub_iterations has 9 tables; it must have 1 to 8");
  EXPECT_EQ(error_of_table(5), "rule.json: sub_iterations[0] must be an object");
  EXPECT_EQ(error_of_table(Json::object()),
            "rule.json: sub_iterations[0] must have raster, makelut, remove, patterns or hensel");
  EXPECT_EQ(error_of_table({{"raster", "01"}, {"hensel", "B/S"}}),
            R"(rule.json: sub_iterations[0] has the unknown key "hensel")");
  EXPECT_EQ(error_of_table({{"hensel", "B9/S"}}),
            "rule.json: sub_iterations[0].hensel is invalid: rule 'B9/S', column 2: expected a "
            "digit from 0 to 8, got '9'");
  EXPECT_EQ(error_of_table({{"patterns", Json::array({"4:(...)->1"})}}),
            "rule.json: sub_iterations[0].patterns is invalid: pattern 1 '4:(...)->1', column 7: "
            "expected a pixel (0, 1, '.' or X), nine in all, got ')'");
  EXPECT_EQ(error_of_table({{"patterns", Json::array()}}),
            "rule.json: sub_iterations[0].patterns has 0 patterns; it must have 1 to 1000");
}

TEST(RuleFile, errors_of_values) {
  std::vector<int> values(512);
  const Json table = {{"makelut", values}};
  EXPECT_EQ(error_of_table(table), "rule.json: sub_iterations[0].order is missing");
  EXPECT_EQ(error_of_table({{"makelut", values}, {"order", "raster"}}),
            R"(rule.json: sub_iterations[0].order must be "matlab" or "octave")");
  EXPECT_EQ(error_of_table({{"remove", values}, {"order", "matlab"}}),
            R"(rule.json: sub_iterations[0].order must be "descriptor", "clockwise" or "raster")");
  EXPECT_EQ(error_of_table({{"remove", values}, {"order", "raster"}}),
            "rule.json: sub_iterations[0].remove has 512 values; it must have 256");
  values[17] = 2;
  EXPECT_EQ(error_of_table({{"makelut", values}, {"order", "matlab"}}),
            "rule.json: sub_iterations[0].makelut[17] must be 0 or 1");
  EXPECT_EQ(error_of_table({{"raster", std::string(511, '0')}}),
            "rule.json: sub_iterations[0].raster has 511 characters; it must have 512 digits 0 and "
            "1 or 128 hexadecimal digits");
  EXPECT_EQ(error_of_table({{"raster", std::string(511, '0') + "2"}}),
            "rule.json: sub_iterations[0].raster has no digit 0 or 1 at position 512");
  EXPECT_EQ(error_of_table({{"raster", "g" + std::string(127, '0')}}),
            "rule.json: sub_iterations[0].raster has no digit 0 to 9 or a to f at position 1");
}

TEST(RuleFile, only_regular_files_of_limited_size_are_read) {
  const std::string directory = testing::TempDir() + "rule_file_test";
  std::filesystem::create_directories(directory);
  const std::string path = directory + "/life.json";
  write_whole_file(path, R"({"hensel": "B3/S23"})");
  EXPECT_EQ(read_rule_file(path).sub_iterations, std::vector{kLife});
  EXPECT_EQ(read_rule_file(path).name, "life");
  write_whole_file(path, R"({"hensel": "B3/S23"})" + std::string(1000000, ' '));
  EXPECT_EQ(error_of_file(path), "cannot read '" + path + "': it has more than 1,000,000 bytes");
  EXPECT_EQ(error_of_file(directory), "cannot read '" + directory + "': it is a directory");
  EXPECT_EQ(error_of_file(directory + "/none"),
            "cannot read '" + directory + "/none': there is no such file");
  const std::string fifo = directory + "/fifo";
  mkfifo(fifo.c_str(), 0600);
  EXPECT_EQ(error_of_file(fifo), "cannot read '" + fifo + "': it is not a regular file");
  std::filesystem::remove_all(directory);
}

TEST(RuleFile, what_is_written_reads_back) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("rule.json");
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
