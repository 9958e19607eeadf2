// Conversion between the packed images of the public interface and planes. Source and target have
// the same size.
#pragma once

#include "core/plane_view.hpp"
#include "thinbench/packed.hpp"

namespace thinbench::detail {

/// Writes all words of a row that hold pixels, with zeros past the width.
void read_packed(const ConstPackedView& source, const BitPlaneView& target);
/// Writes all bytes of a row that hold pixels, with zeros past the width.
void write_packed(const ConstBitPlaneView& source, const PackedView& target);

}  // namespace thinbench::detail
