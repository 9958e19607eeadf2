// Label images from runs as bits and their contacts.
#pragma once

#include "regions/labels_state.hpp"

namespace thinbench::detail {

[[nodiscard]] std::unique_ptr<LabelsState> make_bitpacked_contacts(const LabelsSetting& setting);
[[nodiscard]] std::unique_ptr<LabelsState> make_simd_contacts(const LabelsSetting& setting);

}  // namespace thinbench::detail
