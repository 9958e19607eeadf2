// Table look-up on bytes 0/1, one pixel after another.
//
// lut: eight neighbours gathered into the descriptor of each dark pixel, 256 entries: about 20
// operations a dark pixel. Eight light pixels at a time are passed over.
// lut_sliding: the columns of three pixels slide along the row, eight columns at a time in a
// general register; a window of four columns (12 bits) gives two pixels from a table of 4096
// entries (8 KB). About 4 operations a pixel, dark or light, no branch and no chain of dependences.
// A first form that shifted one column a pixel into a 9-bit window was no faster than lut: 3
// dependent operations and 4 loads a pixel.
#include <cstring>

#include "thinning/passes.hpp"
#include "thinning/rule_table.hpp"

namespace thinbench {
namespace {

/// Eight pixels, the first in the low byte.
std::uint64_t load_word(const std::uint8_t* from) {
  std::uint64_t word = 0;
  std::memcpy(&word, from, sizeof word);
  return word;
}

void store_word(std::uint8_t* to, std::uint64_t word) {
  std::memcpy(to, &word, sizeof word);
}

unsigned descriptor(const std::uint8_t* above, const std::uint8_t* here,
                    const std::uint8_t* below) {
  return static_cast<unsigned>(here[1] | above[1] << 1 | above[0] << 2 | above[-1] << 3 |
                               here[-1] << 4 | below[-1] << 5 | below[0] << 6 | below[1] << 7);
}

struct Lut {
  using Element = std::uint8_t;
  template <class Rule, int sub>
  static bool pass(const RuleModel*, const ConstBytePlaneView& source, const BytePlaneView& target,
                   Index first, Index last) {
    static constexpr RuleTable kTable = make_rule_table<Rule, sub>();
    bool changed = false;
    for (Index y = first; y < last; ++y) {
      changed = row(kTable.data() + 256, source.row(y), source.stride, target.row(y),
                    source.row_elements) ||
                changed;
    }
    return changed;
  }

 private:
  static constexpr Index kStep = 8;

  static bool row(const std::uint8_t* table, const std::uint8_t* here, Index stride,
                  std::uint8_t* target, Index count) {
    bool changed = false;
    for (Index x = 0; x < count; x += kStep) {
      if (load_word(here + x) == 0) {
        store_word(target + x, 0);
        continue;
      }
      for (Index i = x; i < x + kStep; ++i) {
        const std::uint8_t p = here[i];
        const std::uint8_t next =
            p & table[descriptor(here + i - stride, here + i, here + i + stride)];
        changed = changed || next != p;
        target[i] = next;
      }
    }
    return changed;
  }
};

/// Two new pixels, one a byte, for four columns of three pixels. Column c of the window is its bits
/// 3 c to 3 c + 2, south first; the pixels are the middle ones of columns 1 and 2.
using PairTable = std::array<std::uint16_t, 4096>;

constexpr PairTable make_pair_table(const RuleTable& by_descriptor) {
  // Bit i of three adjacent columns is this bit of k + 256 p.
  constexpr std::array<int, 9> bit_of = {5, 4, 3, 6, 8, 2, 7, 0, 1};
  const auto pixel = [&](std::size_t columns) {
    std::size_t index = 0;
    for (std::size_t bit = 0; bit < bit_of.size(); ++bit) {
      index |= (columns >> bit & 1) << bit_of[bit];
    }
    return by_descriptor[index];
  };
  PairTable table{};
  for (std::size_t window = 0; window < table.size(); ++window) {
    table[window] = static_cast<std::uint16_t>(pixel(window & 511) | pixel(window >> 3) << 8);
  }
  return table;
}

struct LutSliding {
  using Element = std::uint8_t;
  template <class Rule, int sub>
  static bool pass(const RuleModel*, const ConstBytePlaneView& source, const BytePlaneView& target,
                   Index first, Index last) {
    static constexpr PairTable kTable = make_pair_table(make_rule_table<Rule, sub>());
    std::uint64_t changed = 0;
    for (Index y = first; y < last; ++y) {
      changed |=
          row(kTable.data(), source.row(y), source.stride, target.row(y), source.row_elements);
    }
    return changed != 0;
  }

 private:
  /// Columns x to x + 7 as four pairs, 6 bits in each 16-bit lane.
  static std::uint64_t column_pairs(const std::uint8_t* here, Index stride) {
    const std::uint64_t columns =
        load_word(here - stride) << 2 | load_word(here) << 1 | load_word(here + stride);
    return (columns | columns >> 5) & 0x003F003F003F003F;
  }

  /// Pixels x to x + 7 need columns x - 1 to x + 8: windows start at odd distances.
  static std::uint64_t row(const std::uint16_t* table, const std::uint8_t* here, Index stride,
                           std::uint8_t* target, Index count) {
    std::uint64_t changed = 0;
    std::uint64_t pairs = column_pairs(here - 1, stride);
    for (Index x = 0; x < count; x += 8) {
      const std::uint64_t following = column_pairs(here + x + 7, stride);
      const std::uint64_t windows = pairs | pairs >> 16 << 6 | following << 54;
      const std::uint64_t next = std::uint64_t{table[windows & 4095]} |
                                 std::uint64_t{table[windows >> 16 & 4095]} << 16 |
                                 std::uint64_t{table[windows >> 32 & 4095]} << 32 |
                                 std::uint64_t{table[windows >> 48]} << 48;
      changed |= next ^ load_word(here + x);
      store_word(target + x, next);
      pairs = following;
    }
    return changed;
  }
};

}  // namespace

constinit const PassTable<std::uint8_t> ScalarPasses::kLut = make_pass_table<Lut>();
constinit const PassTable<std::uint8_t> ScalarPasses::kLutSliding = make_pass_table<LutSliding>();

}  // namespace thinbench
