// Thinning of images larger than memory: packed files are read and written by tiles, in passes. The
// result equals that of thin() bit for bit, and so does the number of iterations.
#pragma once

#include <functional>
#include <string>

#include "images/packed_file.hpp"
#include "out_of_core/conversion.hpp"
#include "out_of_core/tiling.hpp"
#include "thinbench/options.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {

struct OutOfCoreRun {
  Rule rule;
  std::string in = {};
  std::string out = {};  // may be the same file
  PackedFormat format = {};
  Tiling tiling = {};
  Thinning thinning = {};
  Execution execution = {};
  /// Continue after the last pass that an interrupted run finished, if there is one.
  bool resume = false;
  /// Called before each tile, by any thread, with the number of the pass and of the tile.
  std::function<void(int pass, Index tile)> on_tile = {};
  /// Where `in` and `out` are no packed files of this format.
  Conversion conversion = {};
};

struct OutOfCoreResult {
  int iterations;  // including the last one, which changed nothing
  int passes;
  Index foreground_before;
  Index foreground_after;
};

/// The bytes of a tile with its halo when this much memory is to be used in all.
[[nodiscard]] Index block_bytes_for(Index memory, int threads);

/// Thins `in` into `out`, which appears or is replaced when all is done. Work files beside it have
/// the names ".OUT.thinbench-a", "-b", "-state" and "-new". They are removed at the end; a run that
/// fails or is ended after its first pass leaves them for `resume`.
///
/// Throws std::invalid_argument for rules whose changes have no bounded reach (midpoint_scan and
/// spta), that add pixels or have foreground outside, and for options out of range; FileError if a
/// file cannot be read or written, the disk has too little space, or there is nothing suitable to
/// resume.
OutOfCoreResult thin_out_of_core(const OutOfCoreRun& run);

}  // namespace thinbench
