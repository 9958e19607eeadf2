// Rows of the catalogue: an operation, a variant and a number of threads, chosen by name.
#pragma once

#include <string>
#include <vector>

#include "catalog.hpp"

namespace thinbench {

struct Row {
  const ThinningOperation* operation;
  const ThinningVariant* variant;
  int threads;
  std::string name;  // operation/technique/isa/threads

  /// Why the row cannot run on images of this width here; empty where it can.
  [[nodiscard]] std::string_view why_unavailable(Index width) const {
    return thinbench::why_unavailable(*variant, width);
  }
};

/// All rows whose name contains a match of the regular expression (all where it is empty), in the
/// order of the catalogue; threaded variants once for each of `thread_counts`. Throws
/// std::invalid_argument where the expression is malformed.
[[nodiscard]] std::vector<Row> matching_rows(const std::string& filter,
                                             const std::vector<int>& thread_counts);

}  // namespace thinbench
