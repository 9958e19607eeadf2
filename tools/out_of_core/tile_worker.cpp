#include "out_of_core/tile_worker.hpp"

#include <algorithm>
#include <iterator>

#include "support/content_hash.hpp"

namespace thinbench {

namespace {

/// The variants that take the least memory: on tiles, if the rule has them here.
std::vector<detail::ThinningVariant> frugal_variants(const detail::RuleBody& rule,
                                                     std::optional<Isa> isa) {
  const auto& all = detail::thinning_variants(rule);
  std::vector<detail::ThinningVariant> tiles;
  std::copy_if(all.begin(), all.end(), std::back_inserter(tiles), [&](const auto& one) {
    return one.technique == "simd_bitpacked_tiles" && one.isa == isa.value_or(one.isa) &&
           detail::unavailable_reason(one, 0).empty();
  });
  return tiles.empty() ? all : tiles;
}

}  // namespace

TileWorker::TileWorker(const detail::ThinningParameters& parameters, std::optional<Isa> isa,
                       const Tiling& tiling, BitOrder order)
    : parameters_(parameters),
      isa_(isa),
      variants_(frugal_variants(*parameters.rule, isa)),
      tiling_(tiling),
      order_(order),
      bytes_(
          detail::make_aligned<std::uint8_t>(static_cast<std::size_t>(tiling.max_block_bytes()))) {}

PackedView TileWorker::block_view() const {
  return {bytes_.get(), block_.width, block_.height, order_};
}

PackedView TileWorker::tile_view() const {
  const PackedView block = block_view();
  const Index offset = (tile_.y - block_.y) * block.stride + (tile_.x - block_.x) / 8;
  return {block.data + offset, tile_.width, tile_.height, block.stride, order_};
}

Index TileWorker::foreground() const {
  return packed_foreground(tile_view());
}

void TileWorker::read(const PackedFile& source, Index tile) {
  tile_ = tiling_.block(tile);
  block_ = tiling_.block_with_halo(tile);
  source.read(block_, bytes_.get());
}

void TileWorker::write(const PackedFile& target) const {
  const PackedView tile = tile_view();
  target.write(tile_, tile.data, tile.stride);
}

std::uint64_t TileWorker::hash() const {
  const PackedView tile = tile_view();
  const auto bytes = static_cast<std::size_t>(packed_row_bytes(tile.width));
  std::uint64_t hash = 0;
  for (Index y = 0; y < tile.height; ++y) hash = hash_of(tile.row(y), bytes, hash);
  return hash;
}

int TileWorker::run(CachedState& cached, int iterations) {
  const PackedView block = block_view();
  if (cached.state == nullptr || cached.width != block.width || cached.height != block.height ||
      cached.iterations != iterations) {
    cached.state.reset();  // before the next one takes memory
    detail::ThinningParameters parameters = parameters_;
    parameters.max_iterations = iterations;
    const auto& variant = detail::choose_variant(parameters.rule->operation, variants_, block.width,
                                                 block.height, {.threads = 1, .isa = isa_});
    cached = {detail::make_state(variant, block.width, block.height, parameters, 1), block.width,
              block.height, iterations};
  }
  return cached.state->run(block, block);
}

// The last iteration runs alone: its changes say whether the tile has come to rest.
TileOutcome TileWorker::advance(const PackedFile& source, Index tile, int iterations) {
  read(source, tile);
  TileOutcome outcome;
  outcome.before = foreground();
  outcome.after = outcome.before;
  if (outcome.before == 0) return outcome;
  int ran = 0;
  if (iterations > 1) {
    ran = run(many_, iterations - 1);
    outcome.after = foreground();
    const bool at_rest = ran < iterations - 1;
    outcome.last_change = at_rest ? ran - 1 : ran;
    outcome.is_exact = at_rest && tiling_.count() == 1;  // no halo
  }
  if (ran == iterations - 1) {
    const Index before_last = outcome.after;
    run(single_, 1);
    outcome.after = foreground();
    outcome.state.unsettled = outcome.after != before_last;
  }
  outcome.state.changed = outcome.after != outcome.before;
  if (!outcome.state.changed) outcome.last_change = 0;
  return outcome;
}

int TileWorker::last_change(const PackedFile& source, Index tile, const TileOutcome& outcome,
                            int at_least) {
  const auto is_final_after = [&](int iterations) {
    if (iterations == 0) return outcome.before == outcome.after;
    read(source, tile);
    run(many_, iterations);
    return foreground() == outcome.after;
  };
  int low = at_least;
  int high = outcome.last_change;
  if (high <= low || is_final_after(low)) return at_least;
  if (outcome.is_exact || !is_final_after(high - 1)) return high;  // most often
  --high;
  while (high - low > 1) {  // not final after `low`, final after `high`
    const int middle = low + (high - low) / 2;
    (is_final_after(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace thinbench
