// Inputs and what the operations make of them, as image files.
#pragma once

#include <string>
#include <vector>

#include "measure/inputs.hpp"

namespace thinbench {

/// Writes INPUT.png, INPUT_grey.png and INPUT_CASE.png for each operation that gives an image, ':'
/// in the name of a case as '_'. Nets have learned a rule and give the rule's images. Makes the
/// directory where it is missing; errors of files are thrown.
void write_pictures(const std::vector<TimedInput>& inputs, const std::string& directory);

}  // namespace thinbench
