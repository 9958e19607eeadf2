// The search is phase one of the simplex method for: multiples m >= 0 with sum of m s (n, 1) = 0
// and sum of m = 1, s being +1 for vectors that are kept and -1 for those that are removed.
//
// All in integers, without fractions (Edmonds): the tableau holds the true numbers times one common
// positive denominator, which is the last pivot. Each entry is then a minor of a matrix with ten
// rows and entries -1, 0, 1, hence at most 10^5 (Hadamard); the cost row adds ten of them. No
// overflow. Bland's rule, the lowest index first, excludes cycles.
#include <algorithm>
#include <array>

#include "training/cluster.hpp"

namespace thinbench {
namespace {

constexpr std::size_t kRows = kNetInputs + 2;  // the inputs, the constant 1 and the sum of m
constexpr std::size_t kCost = kRows;           // the row below them: what is left to remove
constexpr std::size_t kNone = ~std::size_t{0};

class Tableau {
 public:
  Tableau(const KeepTable& table, DescriptorRun run)
      : first_(run.first), columns_(static_cast<std::size_t>(run.last - run.first) + 1) {
    for (Row& row : rows_) row.resize(columns_ + 1);  // the last column: the right-hand side
    for (std::size_t c = 0; c < columns_; ++c) fill_column(c, table);
    rows_[kRows - 1][columns_] = 1;
    rows_[kCost][columns_] = 1;
    basis_.fill(kNone);  // an artificial variable, one a row, never to return
  }

  /// Moves until nothing is left to remove or nothing can be: whether the former.
  bool solve() {
    while (rows_[kCost][columns_] != 0) {
      const std::size_t column = entering_column();
      if (column == kNone) return false;
      pivot(leaving_row(column), column);
    }
    return true;
  }

  [[nodiscard]] Contradiction solution() const {
    Contradiction found;
    for (std::size_t r = 0; r < kRows; ++r) {
      const std::int64_t times = rows_[r][columns_];
      if (times != 0) found.push_back({first_ + static_cast<int>(basis_[r]), times});
    }
    std::sort(found.begin(), found.end(),
              [](const auto& a, const auto& b) { return a.descriptor < b.descriptor; });
    return found;
  }

 private:
  using Row = std::vector<std::int64_t>;

  void fill_column(std::size_t c, const KeepTable& table) {
    const int k = first_ + static_cast<int>(c);
    const int sign = keeps(table, k) ? 1 : -1;
    for (int i = 0; i < kNetInputs; ++i) {
      rows_[static_cast<std::size_t>(i)][c] = sign * neighbour(k, i);
    }
    rows_[kNetInputs][c] = sign;
    rows_[kNetInputs + 1][c] = 1;
    for (std::size_t r = 0; r < kRows; ++r) rows_[kCost][c] += rows_[r][c];
  }

  [[nodiscard]] std::size_t entering_column() const {
    for (std::size_t c = 0; c < columns_; ++c) {
      if (rows_[kCost][c] > 0) return c;
    }
    return kNone;
  }

  /// The row whose variable reaches 0 first; artificial variables leave first among equals, then
  /// the lowest index.
  [[nodiscard]] std::size_t leaving_row(std::size_t column) const {
    std::size_t best = kNone;
    for (std::size_t r = 0; r < kRows; ++r) {
      if (rows_[r][column] <= 0) continue;
      if (best == kNone || leaves_before(r, best, column)) best = r;
    }
    return best;
  }

  [[nodiscard]] bool leaves_before(std::size_t r, std::size_t other, std::size_t column) const {
    const std::int64_t here = rows_[r][columns_] * rows_[other][column];
    const std::int64_t there = rows_[other][columns_] * rows_[r][column];
    if (here != there) return here < there;
    return basis_[r] + 1 < basis_[other] + 1;  // kNone + 1 is 0
  }

  void pivot(std::size_t row, std::size_t column) {
    const std::int64_t by = rows_[row][column];
    for (std::size_t r = 0; r <= kCost; ++r) {
      if (r == row) continue;
      const std::int64_t factor = rows_[r][column];
      for (std::size_t c = 0; c <= columns_; ++c) {
        rows_[r][c] = (rows_[r][c] * by - factor * rows_[row][c]) / denominator_;
      }
    }
    denominator_ = by;
    basis_[row] = column;
  }

  int first_;
  std::size_t columns_;
  std::array<Row, kRows + 1> rows_;
  std::array<std::size_t, kRows> basis_{};
  std::int64_t denominator_ = 1;
};

}  // namespace

Contradiction find_contradiction(const KeepTable& table, DescriptorRun run) {
  Tableau tableau(table, run);
  return tableau.solve() ? tableau.solution() : Contradiction{};
}

bool shows_inseparable(const Contradiction& contradiction, const KeepTable& table,
                       DescriptorRun run) {
  std::array<std::int64_t, kNetInputs + 1> difference{};
  for (const auto& [k, times] : contradiction) {
    if (times <= 0 || k < run.first || k > run.last) return false;
    const std::int64_t signed_times = keeps(table, k) ? times : -times;
    for (int i = 0; i < kNetInputs; ++i) {
      difference[static_cast<std::size_t>(i)] += signed_times * neighbour(k, i);
    }
    difference[kNetInputs] += signed_times;
  }
  const auto is_zero = [](std::int64_t d) { return d == 0; };
  return !contradiction.empty() && std::all_of(difference.begin(), difference.end(), is_zero);
}

}  // namespace thinbench
