// Rows of the tables: an operation, a variant and a number of threads, chosen by name.
#pragma once

#include <string>
#include <vector>

#include "harness/operation.hpp"

namespace thinbench {

/// "case/technique/isa/threads", as rows are called everywhere.
[[nodiscard]] std::string row_name(std::string_view operation, std::string_view technique,
                                   std::string_view isa, int threads);

struct Row {
  const Operation* operation;
  const Variant* variant;
  int threads;
  std::string name;  // case/technique/isa/threads

  /// Why the row cannot run on images of this width here; empty where it can.
  [[nodiscard]] std::string unavailable_reason(Index width) const {
    return variant->unavailable_reason(width);
  }
};

/// All rows whose name contains a match of the regular expression (all where it is empty), in the
/// order of `operations`, to which they point; threaded variants once for each of `thread_counts`.
/// Throws std::invalid_argument where the expression is malformed.
[[nodiscard]] std::vector<Row> matching_rows(
    const std::string& filter, const std::vector<int>& thread_counts,
    const std::vector<Operation>& operations = all_operations());

}  // namespace thinbench
