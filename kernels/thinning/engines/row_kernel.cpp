// A row of up to 512 pixels in one 512-bit register; the whole image (26 KB for 412 rows) is
// thinned in place in scratch memory that stays in the first-level cache.
//
// Cost a row and sub-iteration: 1 load, 1 store, 4 instructions for the two neighbours (2 lane
// shifts, 2 funnel shifts; 6 without VBMI2), the rule's gates, 1 to notice change. Rows are grouped
// in bands; a band whose neighbourhood did not change during the last cycle is not visited.
//
// Counted and left: with column x in register x mod 8 most neighbours lie in other registers, and a
// row of Guo-Hall's takes 11 vector instructions instead of 15. But then a register's lanes lie
// rows apart (13 at best), and fewer can be passed over: 22,336 instead of 18,228 rows on the test
// image. Bands of 4 rows instead of 7 would visit 17,332. Neighbours kept for the next
// sub-iteration would serve rows that this one did not change only: those that it changed need the
// shifts anew, and which is which would be a branch a row. Column x in
// register x mod 8 again, with eight rows that follow each other in its lanes: no more rows are
// visited than here, and 2 lane shifts a register serve all six neighbours above and below, 13.75
// instructions a row instead of 15 for Guo-Hall's, 11.75 instead of 13 for the printed rule; left
// for what that gains at most, pixels being packed in another order.
//
// Measured and left, with Guo-Hall's rule, 15 vector instructions a row: neighbours from
// unaligned loads instead of lane shifts, 13 instructions, the same time, since each of these loads
// crosses a cache line; column x in lane x mod 8, where neighbours are the row itself stored a lane
// beside and its two outermost lanes shifted, 11 instructions and 8 % slower with the lanes taken
// from the register, 2.6 times as slow with the lanes read back from memory; three rows a turn of
// the loop without moves of registers, 1 % faster.
#include "thinning/engines/row_kernel.hpp"

#include "nets/mux_rule.hpp"
#include "simd/vector.hpp"
#include "thinning/engines/sweep.hpp"

namespace thinbench {
namespace {

/// Beyond the margin there is background.
[[gnu::always_inline]] inline RowOfThree<WordBatch> with_neighbours(WordBatch row) {
  return {west_neighbour<1>(row, previous_word(row)), row, east_neighbour<1>(row, next_word(row))};
}

/// The working image: rows of one block each between two zero rows, in bands of equal height.
struct Bands {
  std::uint64_t* rows;  // row 0
  Index band_rows;

  [[nodiscard]] std::uint64_t* row(Index y) const { return rows + y * kBlockWords; }
};

/// The rows of the working image.
struct RegisterRows {
  const std::uint64_t* data;  // row 0

  [[gnu::always_inline]] RowOfThree<WordBatch> row(Index y) const {
    return with_neighbours(WordBatch::load_aligned(data + y * kBlockWords));
  }

  template <class Rule>
  [[gnu::always_inline]] RowOfThree<WordBatch> features(Index, const RowOfThree<WordBatch>& above,
                                                        const RowOfThree<WordBatch>& here,
                                                        const RowOfThree<WordBatch>& below) const {
    return with_neighbours(Rule::feature(cross(above.centre, here, below.centre)));
  }
};

/// One sub-iteration on bands [first, last), in place. The rows just outside did not change in this
/// step, so memory still holds what the rule must see. Returns a bit for each band that changed.
template <class Rule, int sub>
[[gnu::always_inline]] inline std::uint64_t sweep_bands(const Rule& rule, const Bands& bands,
                                                        int first, int last) {
  std::uint64_t changed_bands = 0;
  std::uint64_t* row = bands.row(first * bands.band_rows);
  Window<Rule, RegisterRows> window(RegisterRows{row}, 0);
  for (int band = first; band < last; ++band) {
    WordBatch changed(std::uint64_t{0});
    for (Index y = 0; y < bands.band_rows; ++y, row += kBlockWords) {
      const WordBatch next = window.template next<sub>(rule, RegisterRows{row}, 0);
      next.store_aligned(row);
      changed = ternary(changed, window.centre(), next,
                        [](auto a, auto b, auto c) { return a | (b ^ c); });
      window.move_down();
    }
    changed_bands |= std::uint64_t{any_bit(changed)} << band;
  }
  return changed_bands;
}

/// Bands that changed, and their neighbours.
constexpr std::uint64_t with_adjacent(std::uint64_t bands) {
  return bands | bands << 1 | bands >> 1;
}

template <class Rule, int sub>
std::uint64_t step(const Rule& rule, const Bands& bands, std::uint64_t active) {
  std::uint64_t changed = 0;
  while (active != 0) {
    const int first = __builtin_ctzll(active);
    const std::uint64_t above_first = ~active >> first;
    const int last = above_first == 0 ? 64 : first + __builtin_ctzll(above_first);
    changed |= sweep_bands<Rule, sub>(rule, bands, first, last);
    active = last == 64 ? 0 : active >> last << last;
  }
  return changed;
}

/// One cycle; `changed[i]` are the bands that sub-iteration i changed when it last ran. True where
/// any changed now.
template <class Rule, int... subs>
bool cycle(const Rule& rule, const Bands& bands, std::uint64_t all, std::uint64_t* changed,
           std::integer_sequence<int, subs...>) {
  const auto recently = [&] { return with_adjacent((changed[subs] | ...)) & all; };
  ((changed[subs] = step<Rule, subs>(rule, bands, recently())), ...);
  return (changed[subs] | ...) != 0;
}

template <class Rule>
int thin_rows(const Rule& rule, int max_iterations, const ConstBitPlaneView& source,
              const BitPlaneView& target, std::uint64_t* scratch) {
  const Index count = row_kernel_bands(source.height);
  const Bands bands = {scratch + kMarginRows * kBlockWords, row_kernel_band_rows(source.height)};
  for (Index y = 0; y < source.height; ++y) {
    WordBatch::load_aligned(source.row(y)).store_aligned(bands.row(y));
  }
  const std::uint64_t all = count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
  std::uint64_t changed[Rule::kSubIterations];
  for (std::uint64_t& mask : changed) mask = all;
  int cycles = 1;
  constexpr auto subs = std::make_integer_sequence<int, Rule::kSubIterations>{};
  while (cycle<Rule>(rule, bands, all, changed, subs) && cycles < max_iterations) ++cycles;
  for (Index y = 0; y < source.height; ++y) {
    WordBatch::load_aligned(bands.row(y)).store_aligned(target.row(y));
  }
  return cycles;
}

template <class Rule>
int fixed_rule(const RuleModel*, int max_iterations, const ConstBitPlaneView& source,
               const BitPlaneView& target, std::uint64_t* scratch) {
  return thin_rows(Rule{}, max_iterations, source, target, scratch);
}

int model_rule(const RuleModel* model, int max_iterations, const ConstBitPlaneView& source,
               const BitPlaneView& target, std::uint64_t* scratch) {
  return thin_rows(MuxRule{model->program}, max_iterations, source, target, scratch);
}

template <class... Rules>
consteval RowKernelTable make_table(RuleList<Rules...>) {
  return {{&fixed_rule<Rules>...}};
}

}  // namespace

template <>
constinit const RowKernelTable RowKernels<kThisIsa>::kTable = make_table(AllRules{});

template <>
constinit const RowKernel RowKernels<kThisIsa>::kModel = &model_rule;

}  // namespace thinbench
