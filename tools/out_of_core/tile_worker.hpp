// Advances one tile of an image in files by some iterations. Has the memory of one thread.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/byte_image.hpp"
#include "images/packed_file.hpp"
#include "out_of_core/checkpoint.hpp"
#include "out_of_core/tiling.hpp"
#include "thinning/operations.hpp"

namespace thinbench {

/// Blocks of `bytes` bytes take this many bytes of memory, at most: the block itself, and two
/// states of 1.25 times its size, one for many iterations and one for the last.
inline constexpr Index kMemoryPerBlockByte = 4;

/// What a pass did with a tile.
struct TileState {
  bool changed = false;    // the pass removed pixels of it
  bool unsettled = false;  // so did the last iteration of the pass
};

struct TileOutcome {
  TileState state;
  Index before = 0;  // foreground pixels
  Index after = 0;
  int last_change = 0;    // the last iteration of the pass that removed pixels of the tile, at most
  bool is_exact = false;  // `last_change` is that iteration
};

/// Rules only remove pixels, so a tile changes if and only if its number of foreground pixels does.
class TileWorker {
 public:
  /// Parameters and tiling must outlive the worker.
  TileWorker(const detail::ThinningParameters& parameters, std::optional<Isa> isa,
             const Tiling& tiling, BitOrder order);

  /// Reads a tile with its halo and advances it by `iterations` iterations.
  TileOutcome advance(const PackedFile& source, Index tile, int iterations);
  /// Reads a tile as it is.
  void read(const PackedFile& source, Index tile);
  /// Writes the tile that was read last.
  void write(const PackedFile& target) const;
  /// A hash of the tile that was read last, as it is now.
  [[nodiscard]] std::uint64_t hash() const;

  /// The exact last iteration of a pass that removed pixels of a tile, if it is above `at_least`;
  /// else `at_least`. `outcome` is that of advance() from the same source.
  int last_change(const PackedFile& source, Index tile, const TileOutcome& outcome, int at_least);

 private:
  struct CachedState {
    std::unique_ptr<detail::ThinningState> state;
    Index width = 0;
    Index height = 0;
    int iterations = 0;
  };

  /// Thins the block in place; returns the number of iterations.
  int run(CachedState& cached, int iterations);
  [[nodiscard]] Index foreground() const;
  [[nodiscard]] PackedView block_view() const;
  [[nodiscard]] PackedView tile_view() const;

  const detail::ThinningParameters& parameters_;
  std::optional<Isa> isa_;
  std::vector<detail::ThinningVariant> variants_;
  const Tiling& tiling_;
  BitOrder order_;
  detail::AlignedArray<std::uint8_t> bytes_;
  Block tile_{};   // the tile that was read last
  Block block_{};  // the same with its halo
  CachedState many_;
  CachedState single_;
};

}  // namespace thinbench
