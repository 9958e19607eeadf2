// States of regions that are compared with those of the product.
#pragma once

#include "regions/labels_state.hpp"
#include "regions/state.hpp"
#include "techniques/byte_planes.hpp"

namespace thinbench::detail {

/// By union-find on pixels: holes and components, and filling.
[[nodiscard]] std::unique_ptr<RegionsState> make_union_find(const RegionsSetting& setting);
[[nodiscard]] std::unique_ptr<RegionsState> make_union_find_fill(const RegionsSetting& setting);

/// Filling from lists of all runs.
[[nodiscard]] std::unique_ptr<RegionsState> make_run_fill(const RegionsSetting& setting);

/// Label images from lists of all runs.
[[nodiscard]] std::unique_ptr<LabelsState> make_run_labels(const LabelsSetting& setting);

/// Euler numbers by a look-up table.
[[nodiscard]] std::unique_ptr<RegionsState> make_euler_quads(const RegionsSetting& setting);

}  // namespace thinbench::detail
