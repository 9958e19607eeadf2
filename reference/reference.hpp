// The paper in plain code: one short function per operation, obviously right, never tuned. It
// shares nothing with the kernels but the views of images.
#pragma once

#include <string_view>

#include "core/views.hpp"

namespace thinbench::reference {

/// Thinning by the modified Naccache-Shinghal rule, section 3.1 of the paper, exactly as printed.
///
/// For each dark pixel four expressions over its eight neighbours are calculated (n0 = east, then
/// anticlockwise, dark is TRUE):
///   B4 = n0 (n1 + n2 + n6 + n7) (n2 + !n3) (!n5 + n6)    left edge points
///   B0 = n4 (n2 + n3 + n5 + n6) (n6 + !n7) (!n1 + n2)    right edge points
///   B2 = n6 (n0 + n4 + n5 + n7) (n0 + !n1) (!n3 + n4)    top edge points
///   B6 = n2 (n0 + n1 + n3 + n4) (n4 + !n5) (!n7 + n0)    bottom edge points
/// If one or two of them are FALSE the pixel becomes light in a second matrix, else it is copied.
/// The second matrix then becomes the image, until a scan changes nothing.
///
/// Outside the image everything is light. `source`: 0 is light, anything else dark; `destination`:
/// 0 and 255, same size, may be the source. Returns the number of scans, the last, which changed
/// nothing, included. Topology is not kept: see NaccacheShinghal in kernels/thinning/rules.hpp.
int thin_naccache_shinghal(ConstByteView source, ByteView destination);

using Thinning = int (*)(ConstByteView source, ByteView destination);

/// The reference of the thinning operation of this name, or nullptr.
[[nodiscard]] Thinning find_thinning(std::string_view operation);

}  // namespace thinbench::reference
