// Holes filled from their runs: all runs are labelled and kept, then those of holes are set.
//
// Cost: that of bitpacked_runs without sums, 8 bytes kept for each run, and for each light run a
// look-up and, in a hole, the words it covers. The image is copied first: a load and a store a
// word.
#include <algorithm>
#include <cstring>
#include <vector>

#include "core/convert.hpp"
#include "core/planes.hpp"
#include "holes/run_band.hpp"
#include "holes/states.hpp"

namespace thinbench {
namespace {

/// All rows of runs of an image, one behind the other. Memory grows by need and is kept.
class KeptRows {
 public:
  explicit KeptRows(Index height) : ends_(static_cast<std::size_t>(height)) {}

  void clear() { used_ = 1; }

  /// Memory for a row of any kind, behind the rows kept. Rows handed out before may move.
  RunRow next_row(Index width) {
    const Index needed = used_ + width + 2 + kWordBits + kKeyPadding;
    if (needed > capacity_) grow(std::max(needed, 2 * capacity_));
    return row_at(used_, 0);
  }
  /// Keeps the row that next_row handed out.
  void keep(Index y, Index count) {
    ends_[static_cast<std::size_t>(y)] = {used_, count};
    used_ += count + kAfterRow + 1;
  }
  [[nodiscard]] RunRow row(Index y) {
    const Place& place = ends_[static_cast<std::size_t>(y)];
    return row_at(place.first, place.count);
  }

 private:
  static constexpr Index kAfterRow = 3;  // last keys that comparing rows may read
  struct Place {
    Index first = 0;
    Index count = 0;
  };

  RunRow row_at(Index first, Index count) {
    keys_[static_cast<std::size_t>(first - 1)] = kFirstKey;
    return {keys_.get() + first, labels_.get() + first, count};
  }

  void grow(Index capacity) {
    auto keys = make_aligned<Key>(static_cast<std::size_t>(capacity));
    auto labels = make_aligned<Label>(static_cast<std::size_t>(capacity));
    std::copy_n(keys_.get(), capacity_, keys.get());
    std::copy_n(labels_.get(), capacity_, labels.get());
    keys_ = std::move(keys);
    labels_ = std::move(labels);
    capacity_ = capacity;
  }

  AlignedArray<Key> keys_;
  AlignedArray<Label> labels_;
  Index capacity_ = 0;
  Index used_ = 1;
  std::vector<Place> ends_;
};

void set_pixels(std::uint64_t* row, std::int64_t begin, std::int64_t end) {
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

class FillState final : public HolesState {
 public:
  explicit FillState(const HolesSetting& setting)
      : conversion_(plane_conversion<std::uint64_t>(setting.isa)),
        source_(setting.width, setting.height),
        result_(setting.width, setting.height),
        labels_(setting.width),
        rows_(setting.height) {}

  void load(const ConstByteView& source) override { conversion_.read(source, source_.view()); }
  void store(const ByteView& destination) const override {
    conversion_.write(result_.view(), destination);
  }
  void compute() override {
    const ConstBitPlaneView image = source_.view();
    if (image.height == 0) return;
    label(image);
    for (Index y = 0; y < image.height; ++y) {
      const auto bytes = static_cast<std::size_t>(image.row_elements) * sizeof(std::uint64_t);
      std::memcpy(result_.view().row(y), image.row(y), bytes);
      fill_row(result_.view().row(y), rows_.row(y));
    }
  }
  [[nodiscard]] bool margins_are_zero() const override {
    return source_.margin_is_zero() && result_.margin_is_zero();
  }

 private:
  void label(const ConstBitPlaneView& image) {
    labels_.clear();
    rows_.clear();
    for (Index y = 0; y < image.height; ++y) label_row(image, y);
    join_border(labels_.tables(), rows_.row(image.height - 1));
    LabelTable& background = labels_.tables().of_colour[0];
    for (Label label = 0; label < background.count; ++label) {
      background.parents[label] = background.parents[background.parents[label]];
    }
  }

  void label_row(const ConstBitPlaneView& image, Index y) {
    labels_.make_room((image.width + 1) / 2);
    Key light_keys[] = {kFirstKey, kLastKey, kLastKey, kLastKey, kLastKey};
    Label outside = 0;
    RunRow here = rows_.next_row(image.width);
    const RunRow above = y > 0 ? rows_.row(y - 1) : RunRow{light_keys + 1, &outside, 0};
    here.count = find_keys(image.row(y), words_with_boundaries(image.width), here.keys);
    label_runs<true>(labels_.tables(), above, 0, here.keys, here.labels, 0, here.count, y);
    rows_.keep(y, here.count);
  }

  void fill_row(std::uint64_t* row, const RunRow& runs) {
    const Label* const roots = labels_.tables().of_colour[0].parents;
    for (Index i = 2; i < runs.count; i += 2) {
      if (roots[runs.labels[i]] == 0) continue;
      set_pixels(row, column_of(runs.keys[i - 1]), column_of(runs.keys[i]));
    }
  }

  const PlaneConversion<std::uint64_t>& conversion_;
  BitPlane source_;
  BitPlane result_;
  LabelStore labels_;
  KeptRows rows_;
};

}  // namespace

std::unique_ptr<HolesState> make_bitpacked_fill(const HolesSetting& setting) {
  return std::make_unique<FillState>(setting);
}

}  // namespace thinbench
