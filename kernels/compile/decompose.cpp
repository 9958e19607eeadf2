#include "compile/decompose.hpp"

namespace thinbench::detail {
namespace {

WindowTable complement(WindowTable table) {
  for (std::uint64_t& word : table.words) word = ~word;
  return table;
}

/// The table with a pixel set to a constant.
WindowTable cofactor(const WindowTable& table, int pixel, bool value) {
  constexpr int kPixelsInWord = 6;
  const WindowTable& ones = pixel_table(pixel);
  WindowTable result;
  for (std::size_t w = 0; w < table.words.size(); ++w) {
    if (pixel < kPixelsInWord) {
      const int shift = 1 << pixel;
      const std::uint64_t half = table.words[w] & (value ? ones.words[w] : ~ones.words[w]);
      result.words[w] = half | (value ? half >> shift : half << shift);
    } else {
      const std::size_t bit = std::size_t{1} << (pixel - kPixelsInWord);
      result.words[w] = table.words[value ? w | bit : w & ~bit];
    }
  }
  return result;
}

}  // namespace

std::optional<SignedValue> Decomposer::found(const WindowTable& table) const {
  if (const auto same = known_.find(table.words); same != known_.end()) {
    return SignedValue{same->second, false};
  }
  if (const auto other = known_.find(complement(table).words); other != known_.end()) {
    return SignedValue{other->second, true};
  }
  return std::nullopt;
}

/// The pixels that the table depends on, in the order of splits.
std::vector<int> Decomposer::support(const WindowTable& table) const {
  std::vector<int> pixels;
  for (const int pixel : order_) {
    if (cofactor(table, pixel, false) != cofactor(table, pixel, true)) pixels.push_back(pixel);
  }
  return pixels;
}

/// The gate of a function of at most three pixels.
Gate Decomposer::small_gate(const WindowTable& table, const std::vector<int>& pixels) {
  Gate gate = {0, {0, 0, 0}};
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    gate.inputs[i] = static_cast<std::uint16_t>(pixels[i]);
  }
  for (std::size_t row = 0; row < 8; ++row) {
    std::size_t window = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      window |= (row << i >> 2 & 1) << pixels[i];  // the first pixel is the highest bit
    }
    if (table[window]) gate.function = static_cast<std::uint8_t>(gate.function | 1 << row);
  }
  return gate;
}

std::optional<SignedValue> Decomposer::add(const WindowTable& table) {
  if (const auto known = found(table)) return known;
  const std::vector<int> pixels = support(table);
  Gate gate;
  if (pixels.size() <= 3) {
    gate = small_gate(table, pixels);
  } else {
    const auto high = add(cofactor(table, pixels[0], true));
    const auto low = add(cofactor(table, pixels[0], false));
    if (!high || !low) return std::nullopt;
    constexpr std::uint8_t kSelect = 0xCA;  // a ? b : c
    gate = {kSelect,
            {static_cast<std::uint16_t>(pixels[0]), static_cast<std::uint16_t>(high->value),
             static_cast<std::uint16_t>(low->value)}};
    if (high->inverted) gate.function = with_inverted_input(gate.function, 1);
    if (low->inverted) gate.function = with_inverted_input(gate.function, 2);
  }
  if (network_.gates.size() >= kMaxGates) return std::nullopt;
  network_.gates.push_back(gate);
  const int value = kWindowPixels + static_cast<int>(network_.gates.size()) - 1;
  know(table, value);
  return SignedValue{value, false};
}

}  // namespace thinbench::detail
