// Tables of rules from notations that are in use: Hensel's, Pillow's, and tables in other
// orders. All functions throw std::invalid_argument with one line that names the value, its
// position and what was expected.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "thinbench/export.h"
#include "thinbench/window_table.hpp"

namespace thinbench {

/// The table of a rule in Hensel's notation, such as B3/S23 or B2-a/S12. After B stand the numbers
/// of foreground neighbours with which a background pixel becomes foreground, after S those with
/// which a foreground pixel remains foreground. Letters after a number choose arrangements of the
/// neighbours, up to rotation and reflection; letters after "-" exclude arrangements:
///     1 and 7    c e
///     2 and 6    c e k a i n
///     3 and 5    c e k a i n y q j r
///     4          c e k a i n y q j r t w z
/// A letter of 5, 6 or 7 is the complement of the same letter of 3, 2 or 1. Either section may come
/// first and may be empty; slash and case do not matter. With B0, too, pixels outside the image
/// never change. Source: the article "Isotropic non-totalistic rule" of LifeWiki.
[[nodiscard]] THINBENCH_API WindowTable table_from_hensel(std::string_view notation);

/// The table of Pillow's ImageMorph.LutBuilder(patterns).build_lut(), byte for byte. A pattern such
/// as "4:(... .1. 111)->1" gives the result for all windows that match: 1 foreground, 0 background,
/// "." or "X" either, in raster order. Before the colon: 1 (nothing), 4 (the four rotations too),
/// M (mirrored too), N (with 0 and 1 exchanged, in the result too), at least one of them, which
/// Pillow does not require. Later patterns override earlier ones; a window without a match keeps
/// its pixel. Whitespace is ignored. At most 1,000 patterns of 1,000 characters. Pillow's MorphOp
/// also clears the outermost pixels of the image, which no table does.
[[nodiscard]] THINBENCH_API WindowTable table_from_patterns(std::span<const std::string> patterns);

/// Which pixel of the window each bit of a table's index is. Windows as in WindowTable:
enum class WindowOrder : std::uint8_t {
  raster,  // bit 0 north-west, bit 1 north, ... bit 8 south-east; Pillow's tables
  matlab,  // by columns: bit 0 north-west, bit 1 west, ...; makelut and bwlookup of MATLAB
  octave,  // by columns from the end: bit 8 north-west, bit 7 west, ...; makelut of Octave
};

/// The table of 512 values, 0 or 1: the new pixel for each window.
[[nodiscard]] THINBENCH_API WindowTable table_from_values(std::span<const std::uint8_t> values,
                                                          WindowOrder order);

/// The bit of the window (0 to 8 without 4) that each bit of a neighbourhood's index is.
using NeighbourOrder = std::array<std::uint8_t, 8>;

/// East, then anticlockwise: this library's descriptors, and the tables of scikit-image's thin.
inline constexpr NeighbourOrder kDescriptorOrder = {5, 2, 1, 0, 3, 6, 7, 8};
/// North-west, then clockwise: the table of scikit-image's skeletonize, method zhang, in which 1
/// and 3 mean removal by the first sub-iteration, 2 and 3 by the second.
inline constexpr NeighbourOrder kClockwiseOrder = {0, 1, 2, 5, 8, 7, 6, 3};
/// North-west, then in raster order.
inline constexpr NeighbourOrder kRasterOrder = {0, 1, 2, 3, 5, 6, 7, 8};

/// The table of a thinning rule: `removed` has 256 values, 1 where a foreground pixel with these
/// neighbours becomes background, else 0. Background pixels remain background.
[[nodiscard]] THINBENCH_API WindowTable table_from_removals(std::span<const std::uint8_t> removed,
                                                            const NeighbourOrder& order);

}  // namespace thinbench
