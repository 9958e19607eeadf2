// What other programs computed, from tables.json (made by record_tables.py).
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "thinbench/window_table.hpp"

namespace thinbench {

inline nlohmann::json recorded() {
  std::ifstream file(THINBENCH_SOURCE_DIR "/tests/rules/tables.json");
  return nlohmann::json::parse(file);
}

/// Hexadecimal digits as bits, the highest bit of a digit first.
inline std::vector<std::uint8_t> bits_of(const std::string& digits) {
  std::vector<std::uint8_t> bits;
  for (const char digit : digits) {
    const int value = std::stoi(std::string(1, digit), nullptr, 16);
    for (int bit = 3; bit >= 0; --bit) bits.push_back(static_cast<std::uint8_t>(value >> bit & 1));
  }
  return bits;
}

inline WindowTable recorded_table(const std::string& digits) {
  const std::vector<std::uint8_t> bits = bits_of(digits);
  return make_window_table([&](std::size_t window) { return bits.at(window); });
}

}  // namespace thinbench
