// Holds a row of up to 512 pixels in one 512-bit register and thins the whole image in place, in
// scratch memory that fits the L1 cache (26 KB for 412 rows).
//
// Cost per row and sub-iteration: 1 load, 1 store, 4 instructions for the two neighbours (2 lane
// shifts, 2 funnel shifts; 6 without VBMI2), the rule's gates, 1 to detect changes, 1 more to keep
// the border. A band of rows is skipped if neither it nor an adjacent band changed during the last
// iteration. One word is the bit set of all bands.
//
// Measured, not adopted: docs/experiments.md#row-kernel.
#include "thinning/engines/row_kernel.hpp"

#include "dispatch/exported.hpp"
#include "simd/vector.hpp"
#include "thinning/engines/mux_rule.hpp"
#include "thinning/engines/word_scan.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

// Templates of a word type, although it is always WordBatch: they are not instantiated on ISAs
// without 512-bit registers.

/// Pixels beyond both ends of the row are background.
template <class Word>
[[gnu::always_inline]] inline RowTriple<Word> with_neighbours(Word row) {
  return {west_neighbour<1>(row, previous_word(row)), row, east_neighbour<1>(row, next_word(row))};
}

/// The rows that may change, one block each, grouped in bands of `band_rows` rows; the last band
/// may have fewer. There are margins above and below.
struct Bands {
  std::uint64_t* first_row;
  Index band_rows;
  int count;
  Index last_band_rows;

  [[nodiscard]] std::uint64_t* row(Index y) const { return first_row + y * kBlockWords; }
};

/// Row access for Window.
template <class Word>
struct RegisterRows {
  const std::uint64_t* data;  // row 0

  [[gnu::always_inline]] RowTriple<Word> row(Index y) const {
    return with_neighbours(Word::load_aligned(data + y * kBlockWords));
  }

  template <class Rule>
  [[gnu::always_inline]] RowTriple<Word> features(Index, const RowTriple<Word>& above,
                                                  const RowTriple<Word>& here,
                                                  const RowTriple<Word>& below) const {
    return with_neighbours(Rule::feature(cross(above.centre, here, below.centre)));
  }
};

/// Rows below the image are background and remain so: all bands are computed with full height.
[[gnu::always_inline]] inline Index rows_of_band(NoFixedPixels, const Bands& bands, int) {
  return bands.band_rows;
}
/// The row below the last band is the last image row, which is fixed: the last band ends above it.
[[gnu::always_inline]] inline Index rows_of_band(const FixedPixels<WordBatch>&, const Bands& bands,
                                                 int band) {
  return band + 1 == bands.count ? bands.last_band_rows : bands.band_rows;
}

/// Applies one sub-iteration to bands [first, last) in place and returns the bands that changed.
/// The adjacent rows outside are unmodified: this sub-iteration does not compute their bands.
template <class Rule, int sub, class Fixed>
[[gnu::always_inline]] inline std::uint64_t scan_bands(const Rule& rule, const Fixed& fixed,
                                                       const Bands& bands, int first, int last) {
  std::uint64_t changed_bands = 0;
  std::uint64_t* row = bands.row(first * bands.band_rows);
  using Rows = RegisterRows<WordBatch>;
  Window<Rule, Rows> window(Rows{row}, 0);
  for (int band = first; band < last; ++band) {
    WordBatch changed(std::uint64_t{0});
    const Index rows = rows_of_band(fixed, bands, band);
    for (Index y = 0; y < rows; ++y, row += kBlockWords) {
      const WordBatch next =
          fixed.apply(window.template next<sub>(rule, Rows{row}, 0), window.centre());
      next.store_aligned(row);
      changed = ternary(changed, window.centre(), next,
                        [](auto a, auto b, auto c) { return a | (b ^ c); });
      window.move_down();
    }
    changed_bands |= std::uint64_t{any_bit(changed)} << band;
  }
  return changed_bands;
}

/// The bands and those adjacent to them.
constexpr std::uint64_t with_adjacent(std::uint64_t bands) {
  return bands | bands << 1 | bands >> 1;
}

/// Applies one sub-iteration to the active bands, run by run, and returns the bands that changed.
template <class Rule, int sub, class Fixed>
std::uint64_t run_sub_iteration(const Rule& rule, const Fixed& fixed, const Bands& bands,
                                std::uint64_t active) {
  std::uint64_t changed = 0;
  while (active != 0) {
    const int first = __builtin_ctzll(active);
    const std::uint64_t gap = ~active >> first;
    const int last = gap == 0 ? 64 : first + __builtin_ctzll(gap);
    changed |= scan_bands<Rule, sub>(rule, fixed, bands, first, last);
    active = last == 64 ? 0 : active >> last << last;
  }
  return changed;
}

/// Runs one iteration. `changed[i]` has the bands that sub-iteration i changed when it last ran.
/// True if anything changed.
template <class Rule, class Fixed, int... subs>
bool iterate_once(const Rule& rule, const Fixed& fixed, const Bands& bands, std::uint64_t all,
                  std::uint64_t* changed, std::integer_sequence<int, subs...>) {
  const auto active = [&] { return with_adjacent((changed[subs] | ...)) & all; };
  ((changed[subs] = run_sub_iteration<Rule, subs>(rule, fixed, bands, active())), ...);
  return (changed[subs] | ...) != 0;
}

template <class Rule, class Fixed>
int repeat(const Rule& rule, const Fixed& fixed, const Bands& bands, int max_iterations) {
  const std::uint64_t all =
      bands.count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bands.count) - 1;
  std::uint64_t changed[Rule::kSubIterations];
  for (std::uint64_t& mask : changed) mask = all;
  int iterations = 1;
  constexpr auto subs = std::make_integer_sequence<int, Rule::kSubIterations>{};
  while (iterate_once(rule, fixed, bands, all, changed, subs) && iterations < max_iterations) {
    ++iterations;
  }
  return iterations;
}

Bands bands_of(std::uint64_t* first_row, Index rows) {
  const Index band_rows = row_kernel_band_rows(rows);
  const Index count = row_kernel_bands(rows);
  return {first_row, band_rows, static_cast<int>(count), rows - (count - 1) * band_rows};
}

/// The mask of the first and the last column.
WordBatch border_columns(Index width) {
  alignas(64) std::uint64_t words[kBlockWords] = {1};
  if (width > 0) words[(width - 1) / kWordBits] |= std::uint64_t{1} << ((width - 1) % kWordBits);
  return WordBatch::load_aligned(words);
}

template <class Rule>
int repeat_with_border(std::uint64_t* rows, const Rule& rule, const RowKernelOptions& options,
                       Index width, Index height) {
  if (options.border == Border::background) {
    return repeat(rule, NoFixedPixels{}, bands_of(rows, height), options.max_iterations);
  }
  if (height <= 2) return 1;  // all rows are border
  const FixedPixels<WordBatch> fixed = {border_columns(width)};
  return repeat(rule, fixed, bands_of(rows + kBlockWords, height - 2), options.max_iterations);
}

void copy_row(const std::uint64_t* from, std::uint64_t* to) {
  WordBatch::load_aligned(from).store_aligned(to);
}

template <class Rule>
int thin_rows(const Rule& rule, const RowKernelOptions& options, const ConstBitPlaneView& source,
              const BitPlaneView& target, std::uint64_t* scratch) {
  std::uint64_t* rows = scratch + kMarginRows * kBlockWords;
  for (Index y = 0; y < source.height; ++y) copy_row(source.row(y), rows + y * kBlockWords);
  const int iterations = repeat_with_border(rows, rule, options, source.width, source.height);
  for (Index y = 0; y < source.height; ++y) copy_row(rows + y * kBlockWords, target.row(y));
  return iterations;
}

template <class Rule>
int compile_time_rule(const RowKernelOptions& options, const ConstBitPlaneView& source,
                      const BitPlaneView& target, std::uint64_t* scratch) {
  return thin_rows(Rule{}, options, source, target, scratch);
}

template <class Rule>
int runtime_rule(const RowKernelOptions& options, const ConstBitPlaneView& source,
                 const BitPlaneView& target, std::uint64_t* scratch) {
  return thin_rows(Rule{options.rule->program}, options, source, target, scratch);
}

template <bool available>
consteval RowKernels make_kernels() {
  RowKernels kernels{};
  if constexpr (available) {
    kernels.runtime = &runtime_rule<MuxRule>;
    for_each_parallel_rule(
        [&]<class Type>(Rule rule) { kernels.by_rule[rule] = &compile_time_rule<Type>; });
  }
  return kernels;
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const RowKernels Exported<RowKernels, kThisIsa>::kKernels =
    make_kernels<kRegisterHoldsRow>();

}  // namespace thinbench::detail
