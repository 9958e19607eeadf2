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

#include <array>
#include <utility>

#include "dispatch/exported.hpp"
#include "simd/vector.hpp"
#include "thinning/engines/custom_scan.hpp"
#include "thinning/engines/layouts.hpp"
#include "thinning/engines/word_scan.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

// Templates of a word type, although it is always WordBatch: they are not instantiated on ISAs
// without 512-bit registers.

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
    return with_neighbours_in_row(Word::load_aligned(data + y * kBlockWords));
  }

  template <class Rule>
  [[gnu::always_inline]] RowTriple<Word> features(Index, const RowTriple<Word>& above,
                                                  const RowTriple<Word>& here,
                                                  const RowTriple<Word>& below) const {
    return with_neighbours_in_row(Rule::feature(cross(above.centre, here, below.centre)));
  }
};

// What is marked as perhaps unused is unused where a register does not hold a row.

/// Rows below the image are background and remain so: all bands are computed with full height.
[[maybe_unused, gnu::always_inline]] inline Index rows_of_band(NoFixedPixels, const Bands& bands,
                                                               int) {
  return bands.band_rows;
}
/// The row below the last band is the last image row, which is fixed: the last band ends above it.
[[maybe_unused, gnu::always_inline]] inline Index rows_of_band(const FixedPixels<WordBatch>&,
                                                               const Bands& bands, int band) {
  return band + 1 == bands.count ? bands.last_band_rows : bands.band_rows;
}

/// Scans bands by a built-in rule.
template <class Rule, class Fixed>
struct BuiltInScan {
  static constexpr int kSubIterations = Rule::kSubIterations;
  Fixed fixed;

  [[nodiscard]] int sub_iterations() const { return kSubIterations; }

  /// Applies sub-iteration `sub` to bands [first, last) in place and returns those that changed.
  /// The adjacent rows outside are unmodified: this sub-iteration does not compute their bands.
  [[nodiscard]] std::uint64_t operator()(int sub, const Bands& bands, int first, int last) const {
    using Function = std::uint64_t (*)(const Fixed&, const Bands&, int, int);
    static constexpr auto functions = []<int... subs>(std::integer_sequence<int, subs...>) {
      return std::array<Function, sizeof...(subs)>{&scan<subs>...};
    }
    (std::make_integer_sequence<int, kSubIterations>{});
    return functions[static_cast<std::size_t>(sub)](fixed, bands, first, last);
  }

 private:
  template <int sub>
  static std::uint64_t scan(const Fixed& fixed, const Bands& bands, int first, int last) {
    using Rows = RegisterRows<WordBatch>;
    std::uint64_t changed_bands = 0;
    std::uint64_t* row = bands.row(first * bands.band_rows);
    Window<Rule, Rows> window(Rows{row}, 0);
    for (int band = first; band < last; ++band) {
      WordBatch changed(std::uint64_t{0});
      const Index rows = rows_of_band(fixed, bands, band);
      for (Index y = 0; y < rows; ++y, row += kBlockWords) {
        const WordBatch next =
            fixed.apply(window.template next<sub>(Rule{}, Rows{row}, 0), window.centre());
        next.store_aligned(row);
        changed = ternary(changed, window.centre(), next,
                          [](auto a, auto b, auto c) { return a | (b ^ c); });
        window.move_down();
      }
      changed_bands |= std::uint64_t{any_bit(changed)} << band;
    }
    return changed_bands;
  }
};

/// Scans bands by a custom rule.
struct CustomScan {
  const BoundRule& rule;
  const void* fixed;  // see ColumnScan

  [[nodiscard]] int sub_iterations() const { return rule.sub_iterations; }

  [[nodiscard]] std::uint64_t operator()(int sub, const Bands& bands, int first, int last) const {
    const Index last_rows = last == bands.count ? bands.last_band_rows : bands.band_rows;
    std::uint64_t* const row = bands.row(first * bands.band_rows);
    constexpr Index stride = kBlockWords * static_cast<Index>(sizeof(std::uint64_t));
    return rule.scans[static_cast<std::size_t>(sub)](
               {.source = row,
                .source_stride = stride,
                .target = row,
                .target_stride = stride,
                .rows = (last - first - 1) * bands.band_rows + last_rows,
                .band_rows = bands.band_rows,
                .fixed = fixed})
           << first;
  }
};

/// The bands and those adjacent to them.
constexpr std::uint64_t with_adjacent(std::uint64_t bands) {
  return bands | bands << 1 | bands >> 1;
}

/// Applies one sub-iteration to the active bands, run by run, and returns the bands that changed.
template <class Scan>
std::uint64_t run_sub_iteration(const Scan& scan, int sub, const Bands& bands,
                                std::uint64_t active) {
  std::uint64_t changed = 0;
  while (active != 0) {
    const int first = __builtin_ctzll(active);
    const std::uint64_t gap = ~active >> first;
    const int last = gap == 0 ? 64 : first + __builtin_ctzll(gap);
    changed |= scan(sub, bands, first, last);
    active = last == 64 ? 0 : active >> last << last;
  }
  return changed;
}

template <class Scan>
int repeat(const Scan& scan, const Bands& bands, int max_iterations) {
  const std::uint64_t all =
      bands.count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bands.count) - 1;
  // What each sub-iteration changed when it last ran.
  std::uint64_t changed_by[kMaxSubIterations] = {};
  const int count = scan.sub_iterations();
  for (int sub = 0; sub < count; ++sub) changed_by[sub] = all;
  const auto changed = [&] {
    std::uint64_t any = 0;
    for (int sub = 0; sub < count; ++sub) any |= changed_by[sub];
    return any;
  };
  int iterations = 0;
  do {
    for (int sub = 0; sub < count; ++sub) {
      changed_by[sub] = run_sub_iteration(scan, sub, bands, with_adjacent(changed()) & all);
    }
    ++iterations;
  } while (iterations < max_iterations && changed() != 0);
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

/// The same and the columns past the width, see ColumnScan.
void set_fixed(const RowKernelOptions& options, Index width, std::uint64_t* words) {
  if (options.border == Border::keep) border_columns(width).store_aligned(words);
  for (Index x = width; x < kRowKernelWidth; ++x) {
    words[x / kWordBits] |= std::uint64_t{1} << (x % kWordBits);
  }
}

template <class Rule>
int repeat_built_in(std::uint64_t* rows, const RowKernelOptions& options, Index width,
                    Index height) {
  if (options.border == Border::background) {
    return repeat(BuiltInScan<Rule, NoFixedPixels>{}, bands_of(rows, height),
                  options.max_iterations);
  }
  if (height <= 2) return 1;  // all rows are border
  using Scan = BuiltInScan<Rule, FixedPixels<WordBatch>>;
  return repeat(Scan{{border_columns(width)}}, bands_of(rows + kBlockWords, height - 2),
                options.max_iterations);
}

[[maybe_unused]] int repeat_custom(std::uint64_t* rows, const RowKernelOptions& options,
                                   Index width, Index height) {
  const auto& rule = *static_cast<const BoundRule*>(options.rule);
  const bool keep = options.border == Border::keep;
  alignas(64) std::uint64_t fixed[kBlockWords] = {};
  if (keep || rule.adds_pixels) set_fixed(options, width, fixed);
  const CustomScan scan = {rule, keep || rule.adds_pixels ? fixed : nullptr};
  if (!keep) return repeat(scan, bands_of(rows, height), options.max_iterations);
  if (height <= 2) return 1;
  return repeat(scan, bands_of(rows + kBlockWords, height - 2), options.max_iterations);
}

[[maybe_unused]] void copy_row(const std::uint64_t* from, std::uint64_t* to) {
  WordBatch::load_aligned(from).store_aligned(to);
}

template <class Repeat>
int thin_rows(const Repeat& repeat_rows, const RowKernelOptions& options,
              const ConstBitPlaneView& source, const BitPlaneView& target, std::uint64_t* scratch) {
  std::uint64_t* rows = scratch + kMarginRows * kBlockWords;
  for (Index y = 0; y < source.height; ++y) copy_row(source.row(y), rows + y * kBlockWords);
  const int iterations = repeat_rows(rows, options, source.width, source.height);
  for (Index y = 0; y < source.height; ++y) copy_row(rows + y * kBlockWords, target.row(y));
  return iterations;
}

template <class Rule>
int built_in_rule(const RowKernelOptions& options, const ConstBitPlaneView& source,
                  const BitPlaneView& target, std::uint64_t* scratch) {
  return thin_rows(&repeat_built_in<Rule>, options, source, target, scratch);
}

template <class Word>
int custom_rule(const RowKernelOptions& options, const ConstBitPlaneView& source,
                const BitPlaneView& target, std::uint64_t* scratch) {
  return thin_rows(&repeat_custom, options, source, target, scratch);
}

template <bool available>
consteval RowKernels make_kernels() {
  RowKernels kernels{};
  if constexpr (available) {
    kernels.custom = &custom_rule<WordBatch>;
    for_each_parallel_rule(
        [&]<class Type>(Rule rule) { kernels.by_rule[rule] = &built_in_rule<Type>; });
  }
  return kernels;
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const RowKernels Exported<RowKernels, kThisIsa>::kKernels =
    make_kernels<kRegisterHoldsRow>();

}  // namespace thinbench::detail
