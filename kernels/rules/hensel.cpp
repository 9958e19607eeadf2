// Hensel's notation of isotropic rules.

#include <array>
#include <bit>
#include <span>

#include "rules/notation_reader.hpp"
#include "rules/window.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench {
namespace {

using detail::NotationReader;

/// A number of neighbours uses the first of these letters; 0 and 8 have one arrangement, unnamed.
constexpr std::string_view kLetters = "cekainyqjrtwz";
constexpr std::array<std::size_t, 9> kArrangements = {1, 2, 6, 10, 13, 10, 6, 2, 1};

// One window per letter, in the order of the letters.
constexpr std::string_view kOne[] = {"1.. ... ...", ".1. ... ..."};
constexpr std::string_view kTwo[] = {"1.1 ... ...", ".1. 1.. ...", "..1 1.. ...",
                                     "11. ... ...", "... 1.1 ...", "..1 ... 1.."};
constexpr std::string_view kThree[] = {"1.1 ... 1..", ".1. 1.1 ...", ".1. ..1 1..", "11. 1.. ...",
                                       "111 ... ...", "1.1 1.. ...", "1.. ..1 1..", ".11 ... 1..",
                                       ".11 1.. ...", "1.. 1.1 ..."};
constexpr std::string_view kFour[] = {"1.1 ... 1.1", ".1. 1.1 .1.", "11. ..1 1..", "111 1.. ...",
                                      "1.1 1.1 ...", "111 ... 1..", "1.1 ..1 1..", ".11 ..1 1..",
                                      ".1. 1.1 1..", "11. 1.1 ...", "1.. 1.1 1..", ".11 1.. 1..",
                                      "..1 1.1 1.."};

/// The position of its letter in kLetters, for every window without its centre.
using LetterTable = std::array<std::uint8_t, WindowTable::kWindows>;

constexpr void add_arrangements(LetterTable& letters, std::span<const std::string_view> windows) {
  for (std::size_t i = 0; i < windows.size(); ++i) {
    std::size_t window = detail::pattern_of(windows[i]).foreground;
    for (int symmetry = 0; symmetry < 8; ++symmetry) {
      window = detail::permuted(window, symmetry == 4 ? detail::kMirror : detail::kRotateBy90);
      letters[window] = static_cast<std::uint8_t>(i);
      if (windows.data() != kFour) letters[detail::kRingBits ^ window] = letters[window];
    }
  }
}

constexpr LetterTable make_letter_table() {
  LetterTable letters{};
  for (const std::span<const std::string_view> windows :
       {std::span<const std::string_view>(kOne), std::span<const std::string_view>(kTwo),
        std::span<const std::string_view>(kThree), std::span<const std::string_view>(kFour)}) {
    add_arrangements(letters, windows);
  }
  return letters;
}

constexpr LetterTable kLetterTable = make_letter_table();

/// For each number of neighbours the arrangements that count: bit i for letter i.
using Section = std::array<unsigned, 9>;

char lower(char symbol) {
  return symbol >= 'A' && symbol <= 'Z' ? static_cast<char>(symbol - 'A' + 'a') : symbol;
}

std::string expected_letter(std::size_t count) {
  const std::string number = std::to_string(count);
  if (kArrangements[count] == 1) return "no letter after " + number;
  return "a letter of " + std::string(kLetters.substr(0, kArrangements[count])) + " after " +
         number;
}

/// The letters after a number; none: 0.
unsigned read_letters(NotationReader& reader, std::size_t count) {
  unsigned letters = 0;
  for (char letter = lower(reader.peek());
       letter >= 'a' && letter <= 'z' && letter != 'b' && letter != 's';
       letter = lower(reader.peek())) {
    const std::size_t i = kLetters.find(letter);
    if (kArrangements[count] == 1 || i >= kArrangements[count]) reader.fail(expected_letter(count));
    if ((letters >> i & 1) != 0) reader.reject(detail::quoted({&letter, 1}) + " is repeated");
    letters |= 1U << i;
    reader.skip();
  }
  return letters;
}

/// A number with its letters.
void read_number(NotationReader& reader, Section& section, unsigned& seen) {
  const auto count = static_cast<std::size_t>(reader.peek() - '0');
  if (count > 8) reader.fail("a digit from 0 to 8");
  if ((seen >> count & 1) != 0) reader.reject(std::to_string(count) + " is repeated");
  seen |= 1U << count;
  reader.skip();
  const bool excluded = reader.accept('-');
  const unsigned letters = read_letters(reader, count);
  if (excluded && letters == 0) reader.fail(expected_letter(count));
  const unsigned all = (1U << kArrangements[count]) - 1;
  section[count] = excluded ? all & ~letters : (letters == 0 ? all : letters);
}

void read_section(NotationReader& reader, Section& section) {
  reader.skip();
  unsigned seen = 0;  // numbers, as bits
  while (reader.peek() >= '0' && reader.peek() <= '9') read_number(reader, section, seen);
}

}  // namespace

WindowTable table_from_hensel(std::string_view notation) {
  NotationReader reader("rule", notation, 256);
  std::array<Section, 2> sections{};  // B, S
  const char first = lower(reader.peek());
  if (first != 'b' && first != 's') reader.fail("B or S");
  read_section(reader, sections[first == 's' ? 1 : 0]);
  reader.accept('/');
  if (lower(reader.peek()) != (first == 's' ? 'b' : 's')) reader.fail(first == 's' ? "B" : "S");
  read_section(reader, sections[first == 's' ? 0 : 1]);
  reader.expect_end();
  return make_window_table([&](std::size_t window) {
    const Section& section = sections[detail::pixel_of(window, WindowTable::kCentre) ? 1 : 0];
    const std::size_t neighbours = window & detail::kRingBits;
    const auto count = static_cast<std::size_t>(std::popcount(neighbours));
    return section[count] >> kLetterTable[neighbours] & 1;
  });
}

}  // namespace thinbench
