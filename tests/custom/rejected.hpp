// The error of a call.
#pragma once

#include <stdexcept>
#include <string>

namespace thinbench {

/// The message of the std::invalid_argument that `call` throws, or "accepted".
template <class Call>
std::string rejection_of(const Call& call) {
  try {
    (void)call();
    return "accepted";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

}  // namespace thinbench
