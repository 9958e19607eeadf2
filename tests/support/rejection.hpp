// Error messages of rejected calls.
#pragma once

#include <stdexcept>
#include <string>

namespace thinbench {

/// The message of the std::invalid_argument that `call` throws; empty if it throws nothing. Other
/// exceptions propagate.
template <class Call>
std::string rejection_of(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// Whether a message is one line without a full stop: programs print it after a colon.
inline bool is_one_sentence(const std::string& text) {
  return !text.empty() && text.find('\n') == std::string::npos &&
         text.find(". ") == std::string::npos && text.back() != '.';
}

}  // namespace thinbench
