// Holds a row of up to 512 pixels in one register of 512 bits and thins the whole image in place,
// in scratch memory that fits the L1 cache (26 KB for 412 rows). A band of rows is skipped if
// neither it nor an adjacent band changed during the last iteration. One word is the bit set of all
// bands.
//
// Alternatives not adopted: docs/experiments.md#row-kernel.
#include <algorithm>
#include <array>
#include <utility>

#include "core/byte_image.hpp"
#include "engines/iterate.hpp"
#include "engines/plane_state.hpp"
#include "engines/variants.hpp"

namespace thinbench::detail {
namespace {

constexpr Index kRegisterBytes = kBlockWords * static_cast<Index>(sizeof(std::uint64_t));

/// Rows are grouped in at most 64 bands of at least 8 rows, so that a word is a bit set of bands.
constexpr Index band_rows_of(Index height) {
  constexpr Index min_rows = 8;
  return height <= 64 * min_rows ? min_rows : (height + 63) / 64;
}

/// The rows that may change, one register each, grouped in bands of `band_rows` rows; the last band
/// may have fewer.
struct Bands {
  std::uint64_t* first_row;
  Index rows;
  Index band_rows;
  Index count;

  Bands(std::uint64_t* first, Index height)
      : first_row(first),
        rows(height),
        band_rows(band_rows_of(height)),
        count((height + band_rows - 1) / band_rows) {}

  [[nodiscard]] std::uint64_t all() const { return ~std::uint64_t{0} >> (64 - count); }
};

/// The bands and those adjacent to them.
constexpr std::uint64_t with_adjacent(std::uint64_t bands) {
  return bands | bands << 1 | bands >> 1;
}

/// Applies one sub-iteration to the active bands, run by run, and returns the bands that changed.
/// The adjacent rows outside a run are unmodified: this sub-iteration does not compute their bands.
/// `scan` has all but the rows of a run.
std::uint64_t run_sub_iteration(const BoundScan& function, const Bands& bands, ColumnScan& scan,
                                std::uint64_t active) {
  std::uint64_t changed = 0;
  while (active != 0) {
    const int first = __builtin_ctzll(active);
    const std::uint64_t gap = ~active >> first;
    const int last = gap == 0 ? 64 : first + __builtin_ctzll(gap);
    const Index first_row = first * bands.band_rows;
    scan.source = scan.target = bands.first_row + first_row * kBlockWords;
    scan.rows = std::min(last * bands.band_rows, bands.rows) - first_row;
    changed |= function(scan) << first;
    active = last == 64 ? 0 : active >> last << last;
  }
  return changed;
}

/// Iterates until nothing changes or the limit is reached; returns the number of iterations.
int iterate_rows(const BoundRule& rule, const std::uint64_t* fixed, const Bands& bands,
                 int max_iterations) {
  ColumnScan scan = {nullptr, kRegisterBytes, nullptr, kRegisterBytes, 0, bands.band_rows, fixed};
  // What each sub-iteration changed when it last ran.
  std::array<std::uint64_t, kMaxSubIterations> changed_by = {};
  std::fill_n(changed_by.begin(), rule.sub_iterations, bands.all());
  const auto changed = [&] {
    std::uint64_t any = 0;
    for (std::size_t sub = 0; sub < rule.sub_iterations; ++sub) any |= changed_by[sub];
    return any;
  };
  int iterations = 0;
  do {
    for (std::size_t sub = 0; sub < rule.sub_iterations; ++sub) {
      changed_by[sub] =
          run_sub_iteration(rule.scans[sub], bands, scan, with_adjacent(changed()) & bands.all());
    }
    ++iterations;
  } while (iterations < max_iterations && changed() != 0);
  return iterations;
}

BitPlane rows_of(const ThinningSetting& setting) {
  return BitPlane::of_block_rows(setting.width, setting.height);
}

class RowState final : public PlaneState<std::uint64_t> {
 public:
  RowState(BoundRule rule, const ThinningSetting& setting)
      : PlaneState(setting, {setting.isa, rows_of(setting), rows_of(setting)}),
        rule_(std::move(rule)),
        border_(setting.border),
        max_iterations_(setting.max_iterations),
        fixed_(fixed_pixels<std::uint64_t>(setting.width, setting.border, rule_.adds_pixels)) {}

  int compute() override {
    const std::uint64_t* const fixed = fixed_.view().data;
    const BitPlaneView rows = planes.result.view();
    std::copy_n(source().data, rows.height * rows.stride, rows.data);
    if (border_ != Border::keep) {
      if (rows.height == 0) return 1;
      return iterate_rows(rule_, fixed, {rows.data, rows.height}, max_iterations_);
    }
    if (rows.height <= 2) return 1;  // all rows are border
    return iterate_rows(rule_, fixed, {rows.row(1), rows.height - 2}, max_iterations_);
  }

 private:
  BoundRule rule_;
  Border border_;
  int max_iterations_;
  BitPlane fixed_;
};

}  // namespace

std::unique_ptr<ThinningState> make_rows(const ThinningSetting& setting) {
  return std::make_unique<RowState>(
      bind(setting.rule, setting.isa, Layout::row, has_fixed_pixels(setting)), setting);
}

}  // namespace thinbench::detail
