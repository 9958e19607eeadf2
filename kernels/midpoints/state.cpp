#include "midpoints/state.hpp"

#include <algorithm>
#include <vector>

#include "core/exported.hpp"
#include "core/layout.hpp"

namespace thinbench::detail {
namespace {

using State = std::unique_ptr<MidpointState>;

Index groups_of(Index rows) {
  return (rows + kGroupRows - 1) / kGroupRows;
}

/// The scan on packed words, with buffers for the chosen directions. Threads share groups of rows
/// and batches of columns.
class ScanState final : public MidpointPlanes<std::uint64_t> {
 public:
  ScanState(const ScanKernels& kernels, const MidpointSetting& setting)
      : MidpointPlanes(setting), kernels_(kernels) {
    work_.directions = setting.directions;
    if (setting.width == 0 || setting.height == 0) work_.directions = kNoDirections;
    for (const Direction direction : kAllDirections) {
      if (work_.directions.has(direction)) add_direction(direction, setting);
    }
    work_.source = planes.source.view();
    work_.target = planes.result.view();
  }

  void mark() override {
    const ThreadTeam& team = bands.threads();
    const Index groups = groups_of(work_.source.height);
    team.for_ranges(groups, [&](Index first, Index last) { kernels_.prepare(work_, first, last); });
    team.for_ranges(static_cast<Index>(tasks_.size()), [&](Index first, Index last) {
      for (Index i = first; i < last; ++i) {
        const Task& task = tasks_[static_cast<std::size_t>(i)];
        kernels_.scan(work_, task.direction, task.first_word);
      }
    });
    team.for_ranges(groups, [&](Index first, Index last) { kernels_.merge(work_, first, last); });
  }

 private:
  struct Task {
    Direction direction;
    Index first_word;
  };

  void add_direction(Direction direction, const MidpointSetting& setting) {
    const Index width = setting.width;
    const Index height = setting.height;
    if (direction == Direction::rows) {
      add_buffer(direction, width, words_for(height), width);
    } else if (direction == Direction::columns) {
      add_buffer(direction, height, words_for(width), height);
    } else {
      const Index ring = words_for(width + 1);
      if (work_.rings.rows == 0) {
        const Index rows = setting.threads > 1 ? groups_of(height) * kGroupRows : kGroupRows;
        work_.rings = make_rows(rows, 2 * ring);
        work_.rings.words = ring;
      }
      add_buffer(direction, height, ring, std::min(width, height));
    }
  }

  void add_buffer(Direction direction, Index rows, Index words, Index longest_run) {
    DirectionBuffer& buffer = work_.buffers[static_cast<int>(direction)];
    buffer.bits = counter_bits(longest_run);
    const Index chunks = (rows + kChunkRows - 1) / kChunkRows;
    buffer.checkpoints = make_words(chunks * buffer.bits * words);
    buffer.pixels = {nullptr, rows, words, 0};
    if (direction != Direction::columns) buffer.pixels = make_rows(rows, words);
    for (Index word = 0; word < words; word += kernels_.batch_words) {
      tasks_.push_back({direction, word});
    }
  }

  /// Words for `pixels` pixels, rounded up to whole batches.
  [[nodiscard]] Index words_for(Index pixels) const {
    return round_up((pixels + kWordBits - 1) / kWordBits, kernels_.batch_words);
  }

  [[nodiscard]] PackedRows make_rows(Index rows, Index words) {
    constexpr Index word_bytes = sizeof(std::uint64_t);
    const Index stride = padded_row_bytes(words * word_bytes) / word_bytes;
    return {make_words(groups_of(rows) * kGroupRows * stride), rows, words, stride};
  }

  [[nodiscard]] std::uint64_t* make_words(Index count) {
    memory_.push_back(make_aligned<std::uint64_t>(static_cast<std::size_t>(count)));
    return memory_.back().get();
  }

  const ScanKernels& kernels_;
  ScanWork work_;
  std::vector<AlignedArray<std::uint64_t>> memory_;
  std::vector<Task> tasks_;
};

}  // namespace

State make_midpoint_scan(const ScanKernels& kernels, const MidpointSetting& setting) {
  return std::make_unique<ScanState>(kernels, setting);
}

namespace {

State make_simd_scan(const MidpointSetting& setting) {
  return make_midpoint_scan(kernels_of<ScanKernels>(setting.isa), setting);
}

}  // namespace

// Why there is no look-up table and no SIMD on bytes:
// docs/experiments.md#midpoint-scan.
const MidpointOperation& midpoint_operation() {
  static const auto& operation = never_destroyed([] {
    VariantList<MidpointState> list;
    for (const Isa isa : isas_of<ScanKernels>()) {
      list.add_with_threads("simd_bitpacked", isa, &make_simd_scan, {2});
    }
    return MidpointOperation{{},
                             "midpoint_scan",
                             "the paper's own method: midpoints of foreground runs along rows, "
                             "columns and both diagonals",
                             list.take()};
  }());
  return operation;
}

void MidpointState::check(const MidpointParameters& parameters, Index width, Index height) {
  require_max_pixels(width, height);
  const Directions directions = parameters.directions;
  require(directions.bits >> kDirectionCount == 0, [&] {
    return "directions: expected bits in [0, 15], got " + std::to_string(directions.bits);
  });
  const Border border = parameters.border;
  require(border == Border::background || border == Border::keep, [&] {
    return "border: expected background or keep, got " +
           (border == Border::foreground ? "foreground" : std::to_string(static_cast<int>(border)));
  });
}

}  // namespace thinbench::detail
