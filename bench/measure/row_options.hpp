// Options that choose rows and inputs, the same for every program that measures.
#pragma once

#include "measure/inputs.hpp"
#include "measure/timed_row.hpp"

namespace CLI {
class App;
}

namespace thinbench {

/// --image, --foreground, --threshold and --input.
void add_input_options(CLI::App& app, InputChoice& inputs);

/// The same and --filter, --variants, --threads and --no-peers.
void add_row_options(CLI::App& app, InputChoice& inputs, RowChoice& rows);

}  // namespace thinbench
