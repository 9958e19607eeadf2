#include "out_of_core/out_of_core.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "core/checks.hpp"
#include "core/thread_team.hpp"
#include "out_of_core/tile_worker.hpp"
#include "out_of_core/work_files.hpp"
#include "support/content_hash.hpp"
#include "support/regular_file.hpp"
#include "thinning/operations.hpp"

namespace thinbench {
namespace {

using detail::require;

detail::ThinningParameters checked_parameters(const OutOfCoreRun& run) {
  const auto parameters = detail::thinning_parameters(run.rule, run.thinning);
  const std::string& name = parameters.rule->operation;
  require(parameters.rule->kind == detail::RuleKind::parallel,
          name +
              " cannot run on tiles; only rules that compute all pixels of a sub-iteration from "
              "the same image can");
  require(!parameters.rule->adds_pixels() && !parameters.complemented,
          name +
              " cannot run on tiles; only rules that add no pixels, with background outside the "
              "image, can");
  detail::require_threads(run.execution.threads);
  if (run.execution.isa) static_cast<void>(isa_name(*run.execution.isa));  // rejects what is none
  return parameters;
}

/// The name of a rule and its tables.
std::string identity_of(const Rule& rule) {
  std::string text(rule.name());
  for (const WindowTable& table : rule.sub_iterations()) {
    text += fmt::format(" {:x}", fmt::join(table.words, ""));
  }
  return text;
}

/// What must be equal for a run to be resumed.
std::string identity_of(const OutOfCoreRun& run, const detail::ThinningParameters& parameters) {
  const bool msb_first = run.format.order == BitOrder::msb_first;
  return fmt::format(
      "{} of {} x {} pixels behind {} bytes, bit order {}, border {}, {} iterations at most, tiles "
      "of {} x {} and {}, input with hash {}{}",
      identity_of(run.rule), run.format.width, run.format.height, run.format.header_bytes(),
      msb_first ? "msb" : "lsb", border_name(parameters.border), parameters.max_iterations,
      run.tiling.tile_width, run.tiling.tile_height, run.tiling.iterations,
      hash_text(hash_of_file(run.in)), run.conversion.name);
}

int number_of_files(const OutOfCoreRun& run) {
  return run.tiling.count() > 1 || run.conversion.unpack ? 2 : 1;
}

class OutOfCore {
 public:
  explicit OutOfCore(const OutOfCoreRun& run)
      : run_(run),
        parameters_(checked_parameters(run)),
        identity_(identity_of(run, parameters_)),
        files_(run.in, run.out, run.format, run.conversion, number_of_files(run)),
        tiles_(static_cast<std::size_t>(run.tiling.count()), {true, true}),
        hashes_(tiles_.size()),
        team_(static_cast<int>(std::min<Index>(run.execution.threads, run.tiling.count()))) {
    for (int i = 0; i < team_.threads(); ++i) {
      workers_.push_back(std::make_unique<TileWorker>(parameters_, run_.execution.isa, run_.tiling,
                                                      run_.format.order));
    }
  }

  OutOfCoreResult thin() {
    begin();
    while (true) {
      const int iterations =
          std::min(run_.tiling.iterations, parameters_.max_iterations - iterations_done());
      run_pass(iterations);
      add_outcomes();
      const bool at_rest = std::ranges::none_of(tiles_, &TileState::unsettled);
      if (at_rest || iterations_done() >= parameters_.max_iterations) {
        const OutOfCoreResult result = {
            at_rest ? last_iteration(iterations) : parameters_.max_iterations, state_.passes,
            state_.foreground_before, state_.foreground_after};
        files_.finish();
        return result;
      }
      save();
      files_.open(state_.passes, state_.passes < 2);
    }
  }

 private:
  void begin() {
    const auto checkpoint = run_.resume ? files_.load(identity_, limits()) : std::nullopt;
    if (!checkpoint) files_.drop_checkpoint();
    if (checkpoint) state_ = *checkpoint;
    files_.open(state_.passes, true);
    if (checkpoint) check_source();
    for (std::size_t i = 0; i < state_.unsettled.size(); ++i) {
      tiles_[i].unsettled = state_.unsettled[i];
    }
  }

  /// A run is saved between two passes.
  [[nodiscard]] CheckpointLimits limits() const {
    const int passes = (parameters_.max_iterations - 1) / run_.tiling.iterations;
    return {run_.tiling.count(), run_.format.width * run_.format.height, passes};
  }

  /// What a resumed run reads must be what the interrupted one wrote.
  void check_source() {
    for (std::size_t i = 0; i < hashes_.size(); ++i) {
      workers_.front()->read(files_.source(), static_cast<Index>(i));
      hashes_[i] = workers_.front()->hash();
    }
    if (hash_of_tiles() == state_.pixels) return;
    cannot_read(files_.source().path(),
                "its pixels are not those that the interrupted run wrote; run without --resume to "
                "begin again");
  }
  [[nodiscard]] std::string hash_of_tiles() const {
    return hash_text(hash_of(hashes_.data(), hashes_.size() * sizeof(hashes_[0])));
  }

  void save() {
    state_.unsettled.clear();
    for (const TileState& tile : tiles_) state_.unsettled.push_back(tile.unsettled);
    state_.pixels = hash_of_tiles();
    files_.save(identity_, state_);
  }

  [[nodiscard]] int iterations_done() const {
    return static_cast<int>(
        std::min<Index>(Index{state_.passes} * run_.tiling.iterations, parameters_.max_iterations));
  }

  /// Tiles that can change in the next pass: what did not come to rest, and its neighbours.
  [[nodiscard]] std::vector<bool> active_tiles() const {
    std::vector<bool> unsettled;
    for (const TileState& tile : tiles_) unsettled.push_back(tile.unsettled);
    return with_neighbours(run_.tiling, unsettled);
  }

  void run_pass(int iterations) {
    active_ = active_tiles();
    outcomes_.assign(tiles_.size(), {});
    std::atomic<Index> next = 0;
    const auto run_tiles = [&](TileWorker& worker) {
      for (Index tile = next++; tile < run_.tiling.count(); tile = next++) {
        if (run_.on_tile) run_.on_tile(state_.passes, tile);
        run_tile(worker, tile, iterations);
      }
    };
    team_.for_ranges(team_.threads(), [&](Index first, Index last) {
      for (Index i = first; i < last; ++i) run_tiles(*workers_[static_cast<std::size_t>(i)]);
    });
  }

  /// Before a pass, its target holds the image before the last pass; new targets hold nothing, and
  /// all tiles count as changed.
  void run_tile(TileWorker& worker, Index tile, int iterations) {
    const auto i = static_cast<std::size_t>(tile);
    const bool target_is_old = state_.passes < 2 || tiles_[i].changed;
    if (!active_[i]) {
      if (!target_is_old) return;
      worker.read(files_.source(), tile);
    } else {
      outcomes_[i] = worker.advance(files_.source(), tile, iterations);
      if (!target_is_old && !outcomes_[i].state.changed) return;
    }
    worker.write(files_.target());
    hashes_[i] = worker.hash();
  }

  void add_outcomes() {
    for (std::size_t i = 0; i < outcomes_.size(); ++i) {
      tiles_[i] = outcomes_[i].state;
      if (state_.passes == 0) state_.foreground_before += outcomes_[i].before;
      state_.foreground_after += outcomes_[i].after - outcomes_[i].before;
    }
    if (state_.passes == 0) state_.foreground_after += state_.foreground_before;
    ++state_.passes;
  }

  /// The number of iterations of thin(), after the pass in which all tiles came to rest.
  [[nodiscard]] int last_iteration(int iterations) {
    std::vector<Index> tiles(outcomes_.size());
    std::iota(tiles.begin(), tiles.end(), Index{0});
    std::ranges::sort(tiles, std::greater{}, [&](Index tile) { return bound(tile); });
    int last = 0;
    for (const Index tile : tiles) {
      if (bound(tile) <= last) break;
      last = workers_.front()->last_change(files_.source(), tile,
                                           outcomes_[static_cast<std::size_t>(tile)], last);
    }
    const Index total = Index{iterations_done()} - iterations + last + 1;
    return static_cast<int>(std::min<Index>(total, parameters_.max_iterations));
  }
  [[nodiscard]] int bound(Index tile) const {
    return outcomes_[static_cast<std::size_t>(tile)].last_change;
  }

  const OutOfCoreRun& run_;
  detail::ThinningParameters parameters_;
  std::string identity_;  // reads the input, and rejects it before there are files
  WorkFiles files_;
  Checkpoint state_;                   // of all passes
  std::vector<TileState> tiles_;       // of the last pass
  std::vector<std::uint64_t> hashes_;  // of the tiles that it left
  std::vector<bool> active_;
  std::vector<TileOutcome> outcomes_;
  detail::ThreadTeam team_;
  std::vector<std::unique_ptr<TileWorker>> workers_;  // one per thread
};

}  // namespace

Index block_bytes_for(Index memory, int threads) {
  return memory / threads / kMemoryPerBlockByte;
}

OutOfCoreResult thin_out_of_core(const OutOfCoreRun& run) {
  return OutOfCore(run).thin();
}

}  // namespace thinbench
