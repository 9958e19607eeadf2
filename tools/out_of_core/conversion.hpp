// Files of other formats, before and after a run on packed files.
#pragma once

#include <functional>
#include <string>

#include "images/packed_file.hpp"

namespace thinbench {

/// How IN becomes a packed file and OUT is made of one. Empty functions: they are packed files
/// themselves.
struct Conversion {
  /// Writes all pixels of IN.
  std::function<void(const PackedFile& to)> unpack = {};
  /// Writes OUT under another name, which is given to it afterwards.
  std::function<void(const PackedFile& from, const std::string& name)> pack = {};
  /// What must be equal for a run to be resumed, beside its options.
  std::string name = {};
};

}  // namespace thinbench
