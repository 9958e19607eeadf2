#include "engines/iterate.hpp"

#include <algorithm>

namespace thinbench::detail {

RowRange changing_rows(Index height, Border border) {
  if (border == Border::background) return {0, height};
  return {1, std::max<Index>(1, height - 1)};
}

BandActivity::BandActivity(RowRange rows, Index row_elements, Index min_column)
    : rows_(rows), row_elements_(row_elements) {
  constexpr Index max_columns = 64;
  const Index narrow_columns = std::max<Index>(1, row_elements / min_column);
  column_elements_ = min_column * ((narrow_columns + max_columns - 1) / max_columns);
  const Index columns = (narrow_columns * min_column + column_elements_ - 1) / column_elements_;
  all_columns_ = row_elements == 0 ? 0 : ~std::uint64_t{0} >> (max_columns - columns);
  const auto bands = static_cast<std::size_t>((rows.last - rows.first + kRows - 1) / kRows);
  active_.resize(bands);
  changed_.resize(bands);
  for (auto& columns_by_band : history_) columns_by_band.resize(bands);
}

void BandActivity::restart() {
  sub_iteration_ = 0;
  for (auto& changed : history_) std::fill(changed.begin(), changed.end(), all_columns_);
}

std::uint64_t BandActivity::active_columns(std::size_t band, int lookback) const {
  const std::size_t from = band == 0 ? 0 : band - 1;
  const std::size_t to = std::min(band + 1, active_.size() - 1);
  std::uint64_t recent = 0;
  for (int back = 1; back <= lookback; ++back) {
    const auto& changed =
        history_[static_cast<std::size_t>(sub_iteration_ - back) % kMaxSubIterations];
    for (std::size_t i = from; i <= to; ++i) recent |= changed[i];
  }
  return (recent | recent << 1 | recent >> 1) & all_columns_;
}

std::span<const Band> BandActivity::begin_sub_iteration(int lookback) {
  // Starts at kMaxSubIterations so that indices into the history are never negative.
  sub_iteration_ = sub_iteration_ == 0 ? kMaxSubIterations : sub_iteration_ + 1;
  active_count_ = 0;
  for (std::size_t band = 0; band < active_.size(); ++band) {
    const std::uint64_t columns = active_columns(band, lookback);
    if (columns == 0) continue;
    const Index first = rows_.first + static_cast<Index>(band) * kRows;
    active_[active_count_++] = {first, std::min(first + kRows, rows_.last), columns,
                                column_elements_, row_elements_};
  }
  return {active_.data(), active_count_};
}

bool BandActivity::end_sub_iteration() {
  auto& now = history_[static_cast<std::size_t>(sub_iteration_) % kMaxSubIterations];
  std::fill(now.begin(), now.end(), 0);
  bool any = false;
  for (std::size_t i = 0; i < active_count_; ++i) {
    now[static_cast<std::size_t>((active_[i].first - rows_.first) / kRows)] = changed_[i];
    any = any || changed_[i] != 0;
  }
  // The second sub-iteration must write all cells, because its target is not initialised.
  if (sub_iteration_ == kMaxSubIterations) std::fill(now.begin(), now.end(), all_columns_);
  return any;
}

}  // namespace thinbench::detail
