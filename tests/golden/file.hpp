// The golden file: tab-separated text with a header and one case per line, sorted.
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

#include "golden/cases.hpp"

namespace thinbench::golden {

inline constexpr const char* kHeader = "operation\tborder\tmax_iterations\timage\thash\titerations";

using Recorded = std::map<Case, Result>;

inline void write_golden(const std::string& path, const Recorded& recorded) {
  std::ofstream file(path);
  file << kHeader << '\n';
  for (const auto& [one, result] : recorded) {
    file << one.operation << '\t' << one.border << '\t' << one.max_iterations << '\t' << one.image
         << '\t' << result.hash << '\t' << result.iterations << '\n';
  }
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

/// Throws std::runtime_error if the file is missing or has another header, or if a line has fewer
/// than six columns.
inline Recorded read_golden(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) || line != kHeader) throw std::runtime_error("no header: " + path);
  Recorded recorded;
  while (std::getline(file, line)) {
    std::istringstream columns(line);
    Case one;
    Result result;
    columns >> one.operation >> one.border >> one.max_iterations >> one.image;
    if (!(columns >> result.hash >> result.iterations))
      throw std::runtime_error("truncated: " + line);
    recorded[one] = result;
  }
  return recorded;
}

}  // namespace thinbench::golden
