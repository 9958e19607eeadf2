// Reads a notation character by character; errors name the column.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace thinbench::detail {

/// The text in quotes, as one line of at most 60 printable characters.
[[nodiscard]] std::string quoted(std::string_view text);

class NotationReader {
 public:
  /// `what` names the text in errors, such as "rule". Throws if the text is longer than `limit`.
  NotationReader(std::string what, std::string_view text, std::size_t limit);

  /// The next character, '\0' at the end.
  [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  [[nodiscard]] bool at_end() const { return at_ == text_.size(); }
  void skip() { ++at_; }
  void skip_whitespace();
  /// Skips `symbol` if it comes next.
  bool accept(char symbol);
  /// Skips `symbol`, which must come next.
  void expect(char symbol);
  void expect_end() const;

  /// Throws std::invalid_argument: "rule 'B9', column 2: expected a digit from 0 to 8, got '9'".
  [[noreturn]] void fail(const std::string& expected) const;
  /// Throws std::invalid_argument: "rule 'B33', column 3: the problem".
  [[noreturn]] void reject(const std::string& problem) const;

 private:
  std::string what_;
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace thinbench::detail
