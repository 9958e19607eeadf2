// What a call executed, in a form that a model of the processor can be given: report/model.py.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace thinbench {

struct ExecutedCode {
  /// The different instructions by address, with a space between them: each as 30 hexadecimal
  /// digits, the bytes from its start, of which it is the first few. Fewer where memory ends.
  std::string instructions;
  /// Numbers of instructions in the order of execution: "3-9*500" for 3 to 9, 500 times in a row.
  std::string order;
};

/// Of instructions in this process. Throws std::runtime_error where its memory cannot be read.
[[nodiscard]] ExecutedCode executed_code(const std::vector<std::uint64_t>& addresses);

}  // namespace thinbench
