#include "timing/row_selection.hpp"

#include <iostream>
#include <map>
#include <stdexcept>

#include "cli/command.hpp"

namespace thinbench {
namespace {

void report_selection(const Selection& selection) {
  for (const std::string& mismatch : selection.mismatches) {
    std::cerr << "not equal to the reference, not timed: " << mismatch << '\n';
  }
  if (!selection.skipped.empty()) {
    std::cerr << "rows skipped: ";
    std::map<std::string, int> reasons;
    for (const SkippedRow& row : selection.skipped) ++reasons[row.reason];
    const char* separator = "";
    for (const auto& [reason, count] : reasons) {
      std::cerr << separator << count << " (" << reason << ')';
      separator = ", ";
    }
    std::cerr << '\n';
  }
}

Selection selected_rows(const std::string& filter, const std::vector<Operation>& operations,
                        const std::vector<TimedInput>& inputs, Levels levels) {
  try {
    return select_rows(filter, operations, inputs, levels);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--filter: ") + error.what());
  }
}

}  // namespace

std::vector<Operation> without_peers(std::vector<Operation> operations) {
  for (Operation& operation : operations) {
    std::erase_if(operation.variants, [](const Variant& variant) { return variant.is_peer; });
  }
  return operations;
}

Selection rows_asked_for(const std::string& filter, const std::vector<Operation>& operations,
                         const std::vector<TimedInput>& inputs, Levels levels) {
  Selection selection = selected_rows(filter, operations, inputs, levels);
  report_selection(selection);
  if (selection.rows.empty()) {
    throw UsageError("no row to time; the filter is '" + filter + "'");
  }
  return selection;
}

}  // namespace thinbench
