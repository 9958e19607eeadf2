// Packed files of tests, and runs on them.
#pragma once

#include <string>

#include "out_of_core/out_of_core.hpp"
#include "support/packed_image.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {

/// A run from `in` to `out` in a directory of its own. Its image has no gaps.
struct PreparedRun {
  PreparedRun(const PackedImage& image, const OutOfCoreRun& options) : run(options) {
    const ConstPackedView view = image.view();
    run.format = {view.width, view.height, view.order};
    run.in = directory.with("in", raw_bytes(image));
    run.out = directory.file("out");
  }

  [[nodiscard]] std::string result() const { return bytes_of(run.out); }

  TemporaryDirectory directory;
  OutOfCoreRun run;
};

/// Tiles that advance by `iterations` iterations in a pass, with the smallest halo.
inline Tiling small_tiles(const Rule& rule, const ConstPackedView& image, int iterations,
                          Index width = 64, Index height = 32) {
  return {image.width, image.height, width, height, rule.reach() * iterations, iterations};
}

}  // namespace thinbench
