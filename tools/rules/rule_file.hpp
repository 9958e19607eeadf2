// Rules given by tables as JSON files:
//     {"name": "my rule",                  default: the file's name
//      "sub_iterations": [table, ...],     1 to 8
//      "border": "background",             or "keep" or "foreground"; default: background
//      "max_iterations": 1}                default: until nothing changes
// "hensel": "B3/S23" may stand for "sub_iterations" with this one table. A table is one of
//     {"raster": "0110..."}                       512 digits 0 and 1, or 128 hexadecimal ones, of
//                                                 which the highest bit comes first
//     {"makelut": [512 values], "order": "matlab"}        or "octave"
//     {"remove": [256 values], "order": "descriptor"}     or "clockwise" or "raster"
//     {"patterns": ["4:(... .1. 111)->1", ...]}
//     {"hensel": "B2-a/S12"}
// whose meaning and orders are those of thinbench/rule_notation.hpp. Values are 0 and 1, or false
// and true.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "thinbench/rule.hpp"

namespace thinbench {

inline constexpr std::size_t kMaxRuleNameLength = 100;

struct RuleDescription {
  std::string name;
  std::vector<WindowTable> sub_iterations;
  Border border = Border::background;
  int max_iterations = kUnlimited;
};

/// Reads a regular file of at most 1 MB. Throws std::runtime_error with one line that names the
/// file and, where there is one, the field. Does not check that a rule without a limit is monotone.
[[nodiscard]] RuleDescription read_rule_file(const std::string& path);

/// The same for text that is at hand; `name` stands for the file in errors.
[[nodiscard]] RuleDescription parse_rule(const std::string& text, const std::string& name);

/// Writes a rule with its tables as 128 hexadecimal digits each. The file appears as a whole or not
/// at all. Throws FileError.
void write_rule_file(const std::string& path, const RuleDescription& rule);

}  // namespace thinbench
