#include "regions/labelled_runs.hpp"

#include <algorithm>

#include "regions/run_labeller.hpp"

namespace thinbench::detail {

RunRow RunStore::next_row(Index width) {
  const Index needed = used_ + width + 2 + kWordBits + kKeyPadding;
  if (needed > capacity_) grow(std::max(needed, 2 * capacity_));
  return row_at({used_, 0});
}

void RunStore::store(Index y, Index count) {
  constexpr Index keys_after_row = 3;  // label_runs reads up to three keys past a row
  rows_[static_cast<std::size_t>(y)] = {used_, count};
  used_ += count + keys_after_row + 1;
}

RunRow RunStore::row(Index y) {
  return row_at(rows_[static_cast<std::size_t>(y)]);
}

RunRow RunStore::row_at(const Place& place) {
  keys_[static_cast<std::size_t>(place.first - 1)] = kFirstKey;
  return {keys_.get() + place.first, labels_.get() + place.first, place.count};
}

void RunStore::grow(Index capacity) {
  auto keys = make_aligned<Key>(static_cast<std::size_t>(capacity));
  auto labels = make_aligned<Label>(static_cast<std::size_t>(capacity));
  std::copy_n(keys_.get(), capacity_, keys.get());
  std::copy_n(labels_.get(), capacity_, labels.get());
  keys_ = std::move(keys);
  labels_ = std::move(labels);
  capacity_ = capacity;
}

void LabelledRuns::label(const ConstBitPlaneView& image) {
  label_rows<false>(image);
  for (int colour = 0; colour < 2; ++colour) {
    Label* const parents = table(colour).parents;
    for (Label label = 0; label < labels(colour); ++label) {
      parents[label] = parents[parents[label]];
    }
  }
}

RegionLists LabelledRuns::label_and_number(const ConstBitPlaneView& image) {
  label_rows<true>(image);
  return labels_.number_regions();
}

template <bool with_sums>
void LabelledRuns::label_rows(const ConstBitPlaneView& image) {
  labels_.clear();
  rows_.clear();
  Key outside_keys[] = {kFirstKey, kLastKey, kLastKey, kLastKey, kLastKey};
  Label outside = 0;
  for (Index y = 0; y < image.height; ++y) {
    labels_.make_room((image.width + 1) / 2);
    RunRow here = rows_.next_row(image.width);
    const RunRow above = y > 0 ? rows_.row(y - 1) : RunRow{outside_keys + 1, &outside, 0};
    here.count = find_keys(image.row(y), words_with_boundaries(image.width), here.keys);
    label_runs<true>(labels_.tables(), above, 0, here.keys, here.labels, 0, here.count, y);
    if (with_sums) add_runs(labels_.tables(), here, y);
    rows_.store(y, here.count);
  }
  join_border(labels_.tables(), rows_.row(image.height - 1));
}

void set_run(std::uint64_t* row, const RunRow& runs, Index i) {
  const std::int64_t begin = column_of(runs.keys[i - 1]);
  const std::int64_t end = column_of(runs.keys[i]);
  const auto first = begin / kWordBits;
  const auto last = (end - 1) / kWordBits;
  const std::uint64_t from_begin = ~std::uint64_t{0} << begin % kWordBits;
  const std::uint64_t to_end = ~std::uint64_t{0} >> (kWordBits - 1 - (end - 1) % kWordBits);
  if (first == last) {
    row[first] |= from_begin & to_end;
    return;
  }
  row[first] |= from_begin;
  for (auto word = first + 1; word < last; ++word) row[word] = ~std::uint64_t{0};
  row[last] |= to_end;
}

}  // namespace thinbench::detail
