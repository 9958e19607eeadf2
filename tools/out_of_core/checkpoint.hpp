// What a run on an image larger than memory keeps between passes, so that it can be resumed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "out_of_core/tiling.hpp"

namespace thinbench {

/// The state after a pass.
struct Checkpoint {
  int passes = 0;
  Index foreground_before = 0;
  Index foreground_after = 0;
  std::vector<bool> unsettled;  // for each tile, whether the last iteration removed pixels of it
  std::string pixels;           // a hash of the image that the pass wrote
};

/// What the checkpoints of a run can hold.
struct CheckpointLimits {
  Index tiles = 0;
  Index pixels = 0;
  int max_passes = 0;
};

/// Writes a file, which may be replaced by half of it after a kill. `identity` is a text that only
/// the same run on the same image has. Throws FileError.
void save_checkpoint(const std::string& path, const std::string& identity,
                     const Checkpoint& checkpoint);

/// Nothing if there is no such file. Throws FileError if the file has another identity, a checksum
/// that is not that of the rest, or a value of another type or beyond the limits.
[[nodiscard]] std::optional<Checkpoint> load_checkpoint(const std::string& path,
                                                        const std::string& identity,
                                                        const CheckpointLimits& limits);

}  // namespace thinbench
