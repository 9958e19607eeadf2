// Text to rules: every field is checked, and the first that is wrong is named.
#include "rules/rule_file.hpp"

#include <filesystem>
#include <functional>
#include <set>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "support/file_bytes.hpp"
#include "support/json_field.hpp"
#include "support/text.hpp"
#include "support/whole_file.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;
using Values = std::vector<std::uint8_t>;

/// The table that `make` returns; its errors name the field.
template <class Make>
WindowTable table_of(const JsonField& field, const Make& make) {
  try {
    return make();
  } catch (const std::invalid_argument& error) {
    field.fail(std::string("is invalid: ") + error.what());
  }
}

WindowTable read_hensel(const JsonField& field) {
  const std::string notation = field.text();
  return table_of(field, [&] { return table_from_hensel(notation); });
}

WindowTable read_patterns(const JsonField& field) {
  std::vector<std::string> patterns;
  const std::size_t count = field.count(1, 1000, "patterns");
  for (std::size_t i = 0; i < count; ++i) patterns.push_back(field.element(i).text());
  return table_of(field, [&] { return table_from_patterns(patterns); });
}

std::uint8_t bit_of(const JsonField& field) {
  const Json& value = field.json();
  if (value.is_boolean()) return value.get<bool>() ? 1 : 0;
  if (value != 0 && value != 1) field.fail("must be 0 or 1");
  return value == 1 ? 1 : 0;
}

Values read_values(const JsonField& field, std::size_t count) {
  Values values(field.count(count, count, "values"));
  for (std::size_t i = 0; i < count; ++i) values[i] = bit_of(field.element(i));
  return values;
}

WindowTable read_makelut(const JsonField& table) {
  const JsonField order = table.member("order");
  const std::string name = order.text();
  if (name != "matlab" && name != "octave") order.fail("must be \"matlab\" or \"octave\"");
  const Values values = read_values(table.member("makelut"), WindowTable::kWindows);
  return table_from_values(values, name == "matlab" ? WindowOrder::matlab : WindowOrder::octave);
}

NeighbourOrder read_order(const JsonField& field) {
  const std::string name = field.text();
  if (name == "descriptor") return kDescriptorOrder;
  if (name == "clockwise") return kClockwiseOrder;
  if (name == "raster") return kRasterOrder;
  field.fail("must be \"descriptor\", \"clockwise\" or \"raster\"");
}

WindowTable read_remove(const JsonField& table) {
  const NeighbourOrder order = read_order(table.member("order"));
  return table_from_removals(read_values(table.member("remove"), 256), order);
}

/// The value of a digit; 16 if it is none.
int digit_value(char digit) {
  const auto value = std::string_view("0123456789abcdef0123456789ABCDEF").find(digit);
  return value == std::string_view::npos ? 16 : static_cast<int>(value % 16);
}

WindowTable read_raster(const JsonField& field) {
  const std::string text = field.text();
  if (text.size() != 512 && text.size() != 128) {
    field.fail("has " + std::to_string(text.size()) +
               " characters; it must have 512 digits 0 and 1 or 128 hexadecimal digits");
  }
  const std::size_t bits = WindowTable::kWindows / text.size();  // of a digit
  WindowTable table;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int value = digit_value(text[i]);
    if (value >= 1 << bits) {
      field.fail("has no digit " + std::string(bits == 1 ? "0 or 1" : "0 to 9 or a to f") +
                 " at position " + std::to_string(i + 1));
    }
    for (std::size_t bit = 0; bit < bits; ++bit) {
      table.set(bits * i + bit, (value >> (bits - 1 - bit) & 1) != 0);
    }
  }
  return table;
}

WindowTable read_table(const JsonField& field) {
  if (field.has("raster")) {
    field.allow_only({"raster"});
    return read_raster(field.member("raster"));
  }
  if (field.has("makelut")) {
    field.allow_only({"makelut", "order"});
    return read_makelut(field);
  }
  if (field.has("remove")) {
    field.allow_only({"remove", "order"});
    return read_remove(field);
  }
  if (field.has("patterns")) {
    field.allow_only({"patterns"});
    return read_patterns(field.member("patterns"));
  }
  field.allow_only({"hensel"});
  if (field.has("hensel")) return read_hensel(field.member("hensel"));
  field.fail("must have raster, makelut, remove, patterns or hensel");
}

std::vector<WindowTable> read_tables(const JsonField& field) {
  std::vector<WindowTable> tables;
  const std::size_t count = field.count(1, Rule::kMaxSubIterations, "tables");
  for (std::size_t i = 0; i < count; ++i) tables.push_back(read_table(field.element(i)));
  return tables;
}

bool is_name(const std::string& text) {
  return !text.empty() && text.size() <= kMaxRuleNameLength && is_printable(text);
}

std::string read_name(const JsonField& field) {
  std::string name = field.text();
  if (!is_name(name)) {
    field.fail("must have 1 to 100 bytes without control characters");
  }
  return name;
}

Border read_border(const JsonField& field) {
  if (const auto border = border_from_name(field.text())) return *border;
  field.fail("must be \"background\", \"keep\" or \"foreground\"");
}

int read_limit(const JsonField& field) {
  const std::int64_t limit = field.integer();
  if (limit < 1 || limit > kUnlimited) field.fail("must lie between 1 and 2147483647");
  return static_cast<int>(limit);
}

/// Rejects repeated keys, of which the parser would take the last.
class RepeatedKeys {
 public:
  explicit RepeatedKeys(const std::string& file) : file_(file) {}

  bool operator()(int depth, Json::parse_event_t event, const Json& parsed) {
    const auto level = static_cast<std::size_t>(depth);
    if (event == Json::parse_event_t::object_start) keys_[level + 1].clear();
    if (event == Json::parse_event_t::key && !keys_[level].insert(parsed.dump()).second) {
      throw std::runtime_error(file_ + ": the key " + shown(parsed) + " is repeated");
    }
    return true;
  }

 private:
  const std::string& file_;
  std::set<std::string> keys_[kMaxJsonDepth + 1];  // of the object at each depth
};

std::string hexadecimal(const WindowTable& table) {
  std::string digits;
  for (std::size_t window = 0; window < WindowTable::kWindows; window += 4) {
    const int value = table[window] << 3 | table[window + 1] << 2 | table[window + 2] << 1 |
                      static_cast<int>(table[window + 3]);
    digits += "0123456789abcdef"[value];
  }
  return digits;
}

}  // namespace

RuleDescription parse_rule(const std::string& text, const std::string& name) {
  RepeatedKeys check(name);
  const Json json = parse_json(text, name, std::ref(check));
  const JsonField root(json, name, "");
  root.allow_only({"name", "sub_iterations", "hensel", "border", "max_iterations"});
  if (root.has("hensel") == root.has("sub_iterations")) {
    root.fail("must have either sub_iterations or hensel");
  }
  RuleDescription rule;
  const std::string stem = std::filesystem::path(name).stem().string();
  rule.name = root.has("name") ? read_name(root.member("name")) : is_name(stem) ? stem : "rule";
  rule.sub_iterations = root.has("hensel") ? std::vector{read_hensel(root.member("hensel"))}
                                           : read_tables(root.member("sub_iterations"));
  if (root.has("border")) rule.border = read_border(root.member("border"));
  if (root.has("max_iterations")) rule.max_iterations = read_limit(root.member("max_iterations"));
  return rule;
}

RuleDescription read_rule_file(const std::string& path) {
  return parse_rule(std::string(read_file(path, kMaxJsonBytes).text()), path);
}

void write_rule_file(const std::string& path, const RuleDescription& rule) {
  auto tables = nlohmann::ordered_json::array();
  for (const WindowTable& table : rule.sub_iterations) {
    tables.push_back({{"raster", hexadecimal(table)}});
  }
  nlohmann::ordered_json json = {
      {"name", rule.name}, {"sub_iterations", tables}, {"border", border_name(rule.border)}};
  if (rule.max_iterations != kUnlimited) json["max_iterations"] = rule.max_iterations;
  write_whole_file(path, json.dump(1) + "\n");
}

}  // namespace thinbench
