// Weights from a file for the nets of an operation.
#pragma once

#include <memory>
#include <string>

#include "api/catalogue.hpp"
#include "thinbench/nets.hpp"

namespace thinbench {

/// The net that `operation` makes of the weights in a file, see weights_file.hpp; nullptr where no
/// file is named. Throws std::runtime_error with one line where the file is malformed, holds
/// weights of the other kind, or the operation takes none.
[[nodiscard]] std::shared_ptr<const NetModel> net_from_file(
    const detail::ThinningOperation& operation, const std::string& path);

}  // namespace thinbench
