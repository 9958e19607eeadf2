// Error messages of rejected calls.
#pragma once

#include <stdexcept>
#include <string>

namespace thinbench {

/// The text of the exception of this type that `call` throws; empty where it throws nothing. Other
/// exceptions pass.
template <class Error = std::invalid_argument, class Call>
std::string rejection_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
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
