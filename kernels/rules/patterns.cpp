// Pillow's patterns of windows.

#include <stdexcept>

#include "rules/notation_reader.hpp"
#include "rules/window.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench {
namespace {

using detail::NotationReader;
using detail::WindowPattern;

constexpr std::size_t kMaxPatterns = 1000;
constexpr std::size_t kMaxPatternLength = 1000;

struct ParsedPattern {
  bool rotations = false;
  bool mirror = false;
  bool negate = false;
  WindowPattern window;
  bool result = false;
};

void read_operations(NotationReader& reader, ParsedPattern& parsed) {
  bool any = false;
  for (; reader.peek() != ':' || !any; reader.skip(), any = true) {
    switch (reader.peek()) {
      case '1':
        break;
      case '4':
        parsed.rotations = true;
        break;
      case 'M':
        parsed.mirror = true;
        break;
      case 'N':
        parsed.negate = true;
        break;
      default:
        reader.fail(any ? "an operation (1, 4, M or N) or ':'" : "an operation: 1, 4, M or N");
    }
  }
}

WindowPattern read_window(NotationReader& reader) {
  WindowPattern window;
  for (std::size_t bit = 1; bit < WindowTable::kWindows; bit <<= 1, reader.skip()) {
    reader.skip_whitespace();
    switch (reader.peek()) {
      case '1':
        window.foreground |= bit;
        break;
      case '0':
        window.background |= bit;
        break;
      case '.':
      case 'X':
        break;
      default:
        reader.fail("a pixel (0, 1, '.' or X), nine in all");
    }
  }
  return window;
}

ParsedPattern parse(const std::string& text, std::size_t number) {
  NotationReader reader("pattern " + std::to_string(number), text, kMaxPatternLength);
  ParsedPattern parsed;
  reader.skip_whitespace();
  read_operations(reader, parsed);
  reader.expect(':');
  reader.skip_whitespace();
  reader.expect('(');
  parsed.window = read_window(reader);
  reader.skip_whitespace();
  reader.expect(')');
  reader.skip_whitespace();
  reader.expect('-');
  reader.expect('>');
  reader.skip_whitespace();
  if (reader.peek() != '0' && reader.peek() != '1') reader.fail("the result, 0 or 1");
  parsed.result = reader.peek() == '1';
  reader.skip();
  reader.skip_whitespace();
  reader.expect_end();
  return parsed;
}

/// Gives the result to all windows that match the pattern or, with its operations, a rotation or
/// mirror image of it.
void set_matches(WindowTable& table, const ParsedPattern& parsed, bool exchange) {
  WindowPattern pattern = parsed.window;
  if (exchange) pattern = {pattern.background, pattern.foreground};
  for (int rotation = 0; rotation < (parsed.rotations ? 4 : 1); ++rotation) {
    const WindowPattern mirrored = permuted(pattern, detail::kMirror);
    for (std::size_t window = 0; window < WindowTable::kWindows; ++window) {
      const bool matches = pattern.matches(window) || (parsed.mirror && mirrored.matches(window));
      if (matches) table.set(window, parsed.result != exchange);
    }
    pattern = permuted(pattern, detail::kRotateBy90);
  }
}

}  // namespace

WindowTable table_from_patterns(std::span<const std::string> patterns) {
  if (patterns.size() > kMaxPatterns) {
    throw std::invalid_argument("expected at most " + std::to_string(kMaxPatterns) +
                                " patterns, got " + std::to_string(patterns.size()));
  }
  WindowTable table = make_window_table(
      [](std::size_t window) { return detail::pixel_of(window, WindowTable::kCentre); });
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    const ParsedPattern parsed = parse(patterns[i], i + 1);
    set_matches(table, parsed, false);
    if (parsed.negate) set_matches(table, parsed, true);
  }
  return table;
}

}  // namespace thinbench
