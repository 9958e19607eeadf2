// Table look-up on bytes 0 and 1, in scalar code.
//
// lut: gathers the eight neighbours of each foreground pixel into its descriptor, the index of a
// table of 256 entries. About 20 operations per foreground pixel; skips eight background pixels at
// a time.
//
// lut_sliding: a window of four columns of three pixels (12 bits) is the index of a table of 4096
// pairs of pixels (8 KB). Eight columns are computed at a time in a general register: about 4
// operations per pixel, without branches or a dependency chain.
//
// Alternatives not adopted: docs/experiments.md#word-scan.
#include "core/byte_order.hpp"
#include "rules/rule_table.hpp"
#include "techniques/passes.hpp"

namespace thinbench::detail {
namespace {

unsigned descriptor(const std::uint8_t* above, const std::uint8_t* here,
                    const std::uint8_t* below) {
  return static_cast<unsigned>(here[1] | above[1] << 1 | above[0] << 2 | above[-1] << 3 |
                               here[-1] << 4 | below[-1] << 5 | below[0] << 6 | below[1] << 7);
}

/// A row by lut. `table` has the new value of a foreground pixel by descriptor.
template <bool has_fixed>
bool lut_row(const std::uint8_t* table, [[maybe_unused]] const std::uint8_t* fixed,
             const std::uint8_t* here, Index stride, std::uint8_t* target, Index count) {
  constexpr Index group = 8;
  bool changed = false;
  for (Index x = 0; x < count; x += group) {
    if (load_bytes(here + x) == 0) {
      store_bytes(target + x, 0);
      continue;
    }
    for (Index i = x; i < x + group; ++i) {
      const std::uint8_t p = here[i];
      std::uint8_t keep = table[descriptor(here + i - stride, here + i, here + i + stride)];
      if constexpr (has_fixed) keep = static_cast<std::uint8_t>(keep | fixed[i]);
      const std::uint8_t next = p & keep;
      changed = changed || next != p;
      target[i] = next;
    }
  }
  return changed;
}

/// Columns x to x + 7 as four pairs, 6 bits in each 16-bit lane.
std::uint64_t column_pairs(const std::uint8_t* here, Index stride) {
  const std::uint64_t columns =
      load_bytes(here - stride) << 2 | load_bytes(here) << 1 | load_bytes(here + stride);
  return (columns | columns >> 5) & 0x003F003F003F003F;
}

/// A row by lut_sliding. Pixels x to x + 7 depend on columns x - 1 to x + 8, so windows start at
/// odd columns.
template <bool has_fixed>
bool sliding_row(const std::uint16_t* table, [[maybe_unused]] const std::uint8_t* fixed,
                 const std::uint8_t* here, Index stride, std::uint8_t* target, Index count) {
  std::uint64_t changed = 0;
  std::uint64_t pairs = column_pairs(here - 1, stride);
  for (Index x = 0; x < count; x += 8) {
    const std::uint64_t following = column_pairs(here + x + 7, stride);
    const std::uint64_t windows = pairs | pairs >> 16 << 6 | following << 54;
    std::uint64_t next = std::uint64_t{table[windows & 4095]} |
                         std::uint64_t{table[windows >> 16 & 4095]} << 16 |
                         std::uint64_t{table[windows >> 32 & 4095]} << 32 |
                         std::uint64_t{table[windows >> 48]} << 48;
    if constexpr (has_fixed) next |= load_bytes(here + x) & load_bytes(fixed + x);
    changed |= next ^ load_bytes(here + x);
    store_bytes(target + x, next);
    pairs = following;
  }
  return changed != 0;
}

/// Calls `row` for the rows of a band, see Pass.
template <class Row, class Table>
std::uint64_t all_rows(const Row& row, const Table* table, const std::uint8_t* fixed,
                       const ConstBytePlaneView& source, const BytePlaneView& target,
                       const Band& band) {
  return for_each_run(band, [&](Index y, Index from, Index to) {
    return row(table, fixed == nullptr ? nullptr : fixed + from, source.row(y) + from,
               source.stride, target.row(y) + from, to - from);
  });
}

std::uint64_t lut_rows(const std::uint8_t* table, const std::uint8_t* fixed,
                       const ConstBytePlaneView& source, const BytePlaneView& target,
                       const Band& band) {
  const auto row = fixed == nullptr ? &lut_row<false> : &lut_row<true>;
  return all_rows(row, table, fixed, source, target, band);
}

std::uint64_t sliding_rows(const std::uint16_t* table, const std::uint8_t* fixed,
                           const ConstBytePlaneView& source, const BytePlaneView& target,
                           const Band& band) {
  const auto row = fixed == nullptr ? &sliding_row<false> : &sliding_row<true>;
  return all_rows(row, table, fixed, source, target, band);
}

constexpr std::size_t kPairTableSize = 4096;

/// `pairs[window]` holds the two new pixels at the centre of a window of four columns and three
/// rows, one per byte. Bits 3 c to 3 c + 2 of the window are its column c, south first.
struct PairTable {
  std::uint16_t pairs[kPairTableSize];
};

constexpr PairTable make_pair_table(const RuleTable& new_pixel) {
  // Maps bit i of three adjacent columns to bit bit_of[i] of k + 256 p.
  constexpr int bit_of[9] = {5, 4, 3, 6, 8, 2, 7, 0, 1};
  const auto pixel = [&](std::size_t columns) {
    std::size_t index = 0;
    for (std::size_t bit = 0; bit < 9; ++bit) index |= (columns >> bit & 1) << bit_of[bit];
    return new_pixel[index];
  };
  PairTable table{};
  for (std::size_t window = 0; window < kPairTableSize; ++window) {
    table.pairs[window] = static_cast<std::uint16_t>(pixel(window & 511) | pixel(window >> 3) << 8);
  }
  return table;
}

struct Lut {
  using Element = std::uint8_t;
  template <class Rule, int sub>
  requires(!TwoStageRule<Rule>)  // 21 input pixels would need a table of 2^21 entries
      static std::uint64_t pass(const std::uint8_t* fixed, const ConstBytePlaneView& source,
                                const BytePlaneView& target, const Band& band) {
    static constexpr RuleTable kTable = make_rule_table<Rule, sub>();
    return lut_rows(kTable.data() + 256, fixed, source, target, band);
  }
};

struct LutSliding {
  using Element = std::uint8_t;
  template <class Rule, int sub>
  requires(!TwoStageRule<Rule>) static std::uint64_t
      pass(const std::uint8_t* fixed, const ConstBytePlaneView& source, const BytePlaneView& target,
           const Band& band) {
    static constexpr PairTable kTable = make_pair_table(make_rule_table<Rule, sub>());
    return sliding_rows(kTable.pairs, fixed, source, target, band);
  }
};

}  // namespace

constinit const PassesByRule<std::uint8_t> LutPasses::kLut = passes_by_rule<Lut>();
constinit const PassesByRule<std::uint8_t> LutPasses::kLutSliding = passes_by_rule<LutSliding>();

}  // namespace thinbench::detail
