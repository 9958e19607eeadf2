// What a run on an image larger than memory keeps between passes, so that it can be resumed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "out_of_core/tiling.hpp"

namespace thinbench {

/// What a pass did with a tile.
struct TileState {
  bool changed = false;    // the pass removed pixels of it
  bool unsettled = false;  // so did the last iteration of the pass
};

/// The state after a pass.
struct Checkpoint {
  int passes = 0;
  int iterations = 0;  // of all passes
  Index foreground_before = 0;
  Index foreground_after = 0;
  std::vector<TileState> tiles;
};

/// Writes a file, which may be replaced by half of it after a kill. `identity` is a text that only
/// the same run on the same image has. Throws FileError.
void save_checkpoint(const std::string& path, const std::string& identity,
                     const Checkpoint& checkpoint);

/// Nothing if there is no such file. Throws FileError if the file is damaged, has another identity
/// or another number of tiles.
[[nodiscard]] std::optional<Checkpoint> load_checkpoint(const std::string& path,
                                                        const std::string& identity, Index tiles);

}  // namespace thinbench
