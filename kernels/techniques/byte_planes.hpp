// Planes of bytes 0 and 1: the conversions that states of planes need. Source and target have the
// same size.
#pragma once

#include "core/packing.hpp"
#include "core/planes.hpp"
#include "thinbench/packed.hpp"

namespace thinbench::detail {

using BytePlane = Plane<std::uint8_t>;
using ConstBytePlaneView = ConstPlaneView<std::uint8_t>;
using BytePlaneView = PlaneView<std::uint8_t>;

void read_packed(const ConstPackedView& source, const BytePlaneView& target);
void write_packed(const ConstBytePlaneView& source, const PackedView& target);
/// Exchanges foreground and background.
void complement(const BytePlaneView& rows);

}  // namespace thinbench::detail
