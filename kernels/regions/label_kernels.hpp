// The kernels that make label images.
#pragma once

#include "core/exported.hpp"
#include "regions/label_table.hpp"

namespace thinbench::detail {

/// What a run is: pixels of one row (4-connected objects; with corners, 8-connected ones), or of a
/// pair of rows that are OR-ed first. Pixels of adjacent columns in a pair are neighbours in any
/// case, so a run of the pair is connected (8-connected objects).
enum class BandKind : std::uint8_t { row, row_with_corners, pair };

[[gnu::always_inline]] inline constexpr Index rows_of(BandKind band) {
  return band == BandKind::pair ? 2 : 1;
}

/// The number of bands of an image; the last one may lack its second row.
[[gnu::always_inline]] inline constexpr Index bands_of(BandKind band, Index height) {
  return (height + rows_of(band) - 1) / rows_of(band);
}

/// Elements before the first and after the last run, which vectors may read.
inline constexpr Index kRunPadding = 16;

/// The runs of an image, numbered band by band from the left. Memory of the caller.
struct RunForest {
  Label* parents;  // an earlier run of the same object, or the run itself
  Label* ids;      // the number of its object, from 1; kRunPadding elements on both sides
  Label* first;    // of each band, the number of its first run; then the number of runs
};

struct LabelKernels {
  /// Counts the runs: sets `first`.
  void (*count)(const ConstBitPlaneView& image, Label* first);
  /// Sets `parents`.
  void (*unite)(const ConstBitPlaneView& image, const RunForest& runs);
  /// Sets `ids`, in raster order of first pixels; returns the number of objects.
  Label (*number)(const ConstBitPlaneView& image, const RunForest& runs);
  /// Adds all pixels to the regions of their objects, which are empty before.
  void (*sum)(const ConstBitPlaneView& image, const RunForest& runs, Region* objects);
  /// Writes the id of every pixel, 0 in the background.
  void (*paint)(const ConstBitPlaneView& image, const RunForest& runs, const LabelView& labels);
};

/// An image, and its runs in pairs of rows.
struct Objects {
  ConstBitPlaneView image;
  RunForest runs;
  Label count;
};

/// Whether the first and the last row of a strip are those of the image.
struct StripEnds {
  bool top = true;
  bool bottom = true;
};

/// Its background as an image, and the runs of single rows.
struct Background {
  ConstBitPlaneView image;
  RunForest runs;
  StripEnds ends;
};

/// Background is 4-connected unless stated otherwise. Run 0 is everything outside the image,
/// connected to all background on the image border; its id is 0.
struct HoleKernels {
  /// Writes the background.
  void (*invert)(const ConstBitPlaneView& image, const BitPlaneView& background);
  void (*count)(const ConstBitPlaneView& background, Label* first);
  void (*unite)(const Background& background);
  /// The same for 8-connected background.
  void (*unite_with_corners)(const Background& background);
  /// Sets `ids`, for holes from `objects` + 1; returns the last id.
  Label (*number)(const Background& background, Label objects);
  /// Adds all pixels to the region at their id, empty before, and sets the enclosing objects of
  /// holes. `regions[0]` is what is outside, for any use. Writes the ids of all runs of single
  /// rows, of both colours, in raster order; returns the end of those.
  Label* (*sum)(const Objects& objects, const Background& background, Region* regions, Label* ids);
  /// Writes the id of every pixel from those of the runs, between kRunPadding elements.
  void (*paint)(const ConstBitPlaneView& image, const ConstBitPlaneView& background,
                const Label* ids, const LabelView& labels);
};

struct LabelEngine {
  LabelKernels eight;
  LabelKernels four;
  HoleKernels holes;  // of 8-connected objects
};
template <>
inline constexpr Features kGainsFrom<LabelEngine> = feature("popcnt") | feature("avx2") |
                                                    feature("avx512bw") |
                                                    feature("avx512vpopcntdq");

}  // namespace thinbench::detail
