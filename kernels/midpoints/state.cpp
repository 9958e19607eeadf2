#include "midpoints/state.hpp"

#include <algorithm>

#include "image/layout.hpp"

namespace thinbench::detail {
namespace {

constexpr Index kWordBytes = sizeof(std::uint64_t);

/// Whole batches for `pixels` pixels.
Index words_for(Index pixels, Index batch_words) {
  return round_up((pixels + kWordBits - 1) / kWordBits, batch_words);
}

}  // namespace

ScanState::ScanState(const ScanKernels& kernels, const ThinningSetting& setting)
    : PlaneState(setting), kernels_(kernels), border_(setting.border) {
  work_.directions = setting.directions;
  if (setting.width == 0 || setting.height == 0) work_.directions = kNoDirections;
  for (const Direction direction : kAllDirections) {
    if (work_.directions.has(direction)) add_direction(direction, setting);
  }
  work_.source = planes.source.view();
  work_.target = planes.result.view();
}

void ScanState::add_direction(Direction direction, const ThinningSetting& setting) {
  const Index width = setting.width;
  const Index height = setting.height;
  const Index batch = kernels_.batch_words;
  if (direction == Direction::rows) {
    turn(direction, width, words_for(height, batch), width);
  } else if (direction == Direction::columns) {
    turn(direction, height, words_for(width, batch), height);
  } else {
    const Index ring = words_for(width + 1, batch);
    if (work_.rings.rows == 0) {
      work_.rings = make_sheet(setting.threads > 1 ? round_up(height, kGroupRows) : kGroupRows, 2 * ring);
      work_.rings.words = ring;
    }
    turn(direction, height, ring, std::min(width, height));
  }
}

void ScanState::turn(Direction direction, Index rows, Index words, Index longest) {
  Turned& turned = work_.turned[static_cast<int>(direction)];
  turned.bits = counter_bits(longest);
  const Index chunks = (rows + kChunkRows - 1) / kChunkRows;
  turned.checkpoints = make_words(chunks * turned.bits * words);
  turned.sheet = {nullptr, rows, words, 0};
  if (direction != Direction::columns) turned.sheet = make_sheet(rows, words);
  for (Index word = 0; word < words; word += kernels_.batch_words) {
    tasks_.push_back({direction, word});
  }
}

Sheet ScanState::make_sheet(Index rows, Index words) {
  const Index stride = padded_row_bytes(words * kWordBytes) / kWordBytes;
  return {make_words(round_up(rows, kGroupRows) * stride), rows, words, stride};
}

std::uint64_t* ScanState::make_words(Index count) {
  memory_.push_back(make_aligned<std::uint64_t>(static_cast<std::size_t>(count)));
  return memory_.back().get();
}

int ScanState::thin() {
  const Index groups = group_count(work_.source.height);
  team.for_ranges(groups, [&](Index first, Index last) { kernels_.prepare(work_, first, last); });
  team.for_ranges(static_cast<Index>(tasks_.size()), [&](Index first, Index last) {
    for (Index i = first; i < last; ++i) {
      const Task& task = tasks_[static_cast<std::size_t>(i)];
      kernels_.sweep(work_, task.direction, task.first_word);
    }
  });
  team.for_ranges(groups, [&](Index first, Index last) { kernels_.merge(work_, first, last); });
  apply_border(border_, work_.source, work_.target);
  return 1;
}

namespace {

void copy_pixel(const std::uint8_t* from, std::uint8_t* to, Index x) {
  to[x] = from[x];
}

void copy_pixel(const std::uint64_t* from, std::uint64_t* to, Index x) {
  const std::uint64_t bit = std::uint64_t{1} << (x % kWordBits);
  std::uint64_t& word = to[x / kWordBits];
  word ^= (word ^ from[x / kWordBits]) & bit;
}

}  // namespace

template <class T>
void apply_border(Border border, const ConstPlaneView<T>& source, const PlaneView<T>& target) {
  if (border == Border::background || source.width == 0) return;
  for (Index y = 0; y < source.height; ++y) {
    if (y == 0 || y == source.height - 1) {
      std::copy_n(source.row(y), source.row_elements, target.row(y));
    }
    copy_pixel(source.row(y), target.row(y), 0);
    copy_pixel(source.row(y), target.row(y), source.width - 1);
  }
}

template void apply_border(Border, const ConstBytePlaneView&, const BytePlaneView&);
template void apply_border(Border, const ConstBitPlaneView&, const BitPlaneView&);

}  // namespace thinbench::detail
