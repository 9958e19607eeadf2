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

ScanState::ScanState(const ScanKernels& kernels, const ScanSetting& setting)
    : PlaneState(setting.isa, setting.width, setting.height),
      kernels_(kernels),
      team_(setting.threads) {
  work_.directions = setting.directions;
  if (setting.width == 0 || setting.height == 0) work_.directions = kNoDirections;
  for (const Direction direction : kAllDirections) {
    if (work_.directions.has(direction)) add_direction(direction, setting);
  }
  work_.source = planes.source.view();
  work_.target = planes.result.view();
}

void ScanState::add_direction(Direction direction, const ScanSetting& setting) {
  const auto [isa, width, height, threads, directions] = setting;
  const Index batch = kernels_.batch_words;
  if (direction == Direction::rows) {
    turn(direction, width, words_for(height, batch), width);
  } else if (direction == Direction::columns) {
    turn(direction, height, words_for(width, batch), height);
  } else {
    const Index ring = words_for(width + 1, batch);
    if (work_.rings.rows == 0) {
      work_.rings = make_sheet(threads > 1 ? round_up(height, kGroupRows) : kGroupRows, 2 * ring);
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
  team_.for_ranges(groups, [&](Index first, Index last) { kernels_.prepare(work_, first, last); });
  team_.for_ranges(static_cast<Index>(tasks_.size()), [&](Index first, Index last) {
    for (Index i = first; i < last; ++i) {
      const Task& task = tasks_[static_cast<std::size_t>(i)];
      kernels_.sweep(work_, task.direction, task.first_word);
    }
  });
  team_.for_ranges(groups, [&](Index first, Index last) { kernels_.merge(work_, first, last); });
  return 1;
}

}  // namespace thinbench::detail
