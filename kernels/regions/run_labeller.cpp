#include "regions/run_labeller.hpp"

#include <algorithm>

namespace thinbench::detail {

RunLabeller::RunLabeller(LabelRows label_rows, Index width, Index height, int threads)
    : label_rows_(label_rows), team_(threads) {
  const Index bands = std::min<Index>(threads, height);
  for (Index band = 0; band < bands; ++band) bands_.emplace_back(width);
}

RegionLists RunLabeller::label(const ConstBitPlaneView& image) {
  if (bands_.empty()) return {};
  const auto count = static_cast<Index>(bands_.size());
  team_.for_ranges(count, [&](Index first, Index last) {
    for (Index band = first; band < last; ++band) {
      bands_[static_cast<std::size_t>(band)].label(label_rows_, image, image.height * band / count,
                                                   image.height * (band + 1) / count);
    }
  });
  LabelStore& labels = bands_.front().labels();
  for (std::size_t i = 1; i < bands_.size(); ++i) {
    join_bands(labels, bands_[i - 1].last_row(), bands_[i]);
  }
  join_border(labels.tables(), bands_.front().first_row());
  join_border(labels.tables(), bands_.back().last_row());
  return labels.number_regions();
}

}  // namespace thinbench::detail
