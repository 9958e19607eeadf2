// Options that choose rows and inputs, the same for every program that measures.
#pragma once

#include <CLI/CLI.hpp>

#include "measure/inputs.hpp"
#include "measure/timed_row.hpp"

namespace thinbench {

void add_row_options(CLI::App& app, InputChoice& inputs, RowChoice& rows);

}  // namespace thinbench
