// Filling holes.
#pragma once

#include <memory>

#include "regions/state.hpp"

namespace thinbench::detail {

/// Floods the background, or labels its runs where that takes long or areas of holes are asked for.
[[nodiscard]] std::unique_ptr<RegionsState> make_fill(const RegionsSetting& setting);

}  // namespace thinbench::detail
