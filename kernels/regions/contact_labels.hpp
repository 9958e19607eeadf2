// Label images from runs as bits and their contacts.
#pragma once

#include "regions/labels_state.hpp"

namespace thinbench::detail {

/// By the kernels of the setting's ISA.
[[nodiscard]] std::unique_ptr<LabelsState> make_contact_labels(const LabelsSetting& setting);

}  // namespace thinbench::detail
