#include "rules/notation_reader.hpp"

#include <stdexcept>
#include <utility>

namespace thinbench::detail {

std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string line(1, '\'');
  for (const char symbol : text.substr(0, kLongest)) {
    line += symbol >= ' ' && symbol <= '~' ? symbol : '?';
  }
  return line + (text.size() > kLongest ? "...'" : "'");
}

NotationReader::NotationReader(std::string what, std::string_view text, std::size_t limit)
    : what_(std::move(what)), text_(text) {
  if (text.size() <= limit) return;
  at_ = limit;
  reject("expected at most " + std::to_string(limit) + " characters, got " +
         std::to_string(text.size()));
}

void NotationReader::skip_whitespace() {
  while (!at_end() && (peek() == ' ' || peek() == '\t' || peek() == '\n' || peek() == '\r')) skip();
}

bool NotationReader::accept(char symbol) {
  if (at_end() || peek() != symbol) return false;
  skip();
  return true;
}

void NotationReader::expect(char symbol) {
  if (!accept(symbol)) fail(quoted(std::string_view(&symbol, 1)));
}

void NotationReader::expect_end() const {
  if (!at_end()) fail("the end");
}

void NotationReader::fail(const std::string& expected) const {
  const std::string found = at_end() ? "the end" : quoted(text_.substr(at_, 1));
  reject("expected " + expected + ", got " + found);
}

void NotationReader::reject(const std::string& problem) const {
  throw std::invalid_argument(what_ + " " + quoted(text_) + ", column " + std::to_string(at_ + 1) +
                              ": " + problem);
}

}  // namespace thinbench::detail
