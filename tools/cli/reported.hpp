// How every program here ends.
#pragma once

#include <functional>
#include <ostream>
#include <string>

namespace thinbench {

/// Runs a program and flushes `out`. Returns its status or, after one line in `err` that begins
/// with its name, that of a failure.
int run_and_report(const std::string& program, std::ostream& out, std::ostream& err,
                   const std::function<int()>& run);

}  // namespace thinbench
