// The golden file: tab-separated text. The header names the images; each line is an operation with
// its options, sorted, and has a result per image.
#pragma once

#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "golden/cases.hpp"

namespace thinbench::golden {

inline constexpr const char* kHeader = "operation\tborder";

inline constexpr const char* kNone = "-";  // the operation has no such input

using Recorded = std::map<Case, Result>;

inline void write_golden(const std::string& path, const Recorded& recorded) {
  std::set<std::string> images;
  for (const auto& [one, result] : recorded) images.insert(one.image);
  std::ofstream file(path);
  file << kHeader;
  for (const std::string& image : images) file << '\t' << image;
  for (auto row = recorded.begin(); row != recorded.end();) {
    Case one = row->first;
    file << '\n' << one.operation << '\t' << one.border;
    for (const std::string& image : images) {
      one.image = image;
      const auto found = recorded.find(one);
      file << '\t' << (found == recorded.end() ? kNone : found->second);
    }
    row = recorded.upper_bound(one);
  }
  if (!(file << '\n').flush()) throw std::runtime_error("cannot write " + path);
}

/// Throws std::runtime_error if the file is missing or has another header, or if a line has fewer
/// results than the header has images.
inline Recorded read_golden(const std::string& path) {
  std::ifstream file(path);
  std::string line, name;
  if (!std::getline(file, line) || !line.starts_with(kHeader)) {
    throw std::runtime_error("no header: " + path);
  }
  std::istringstream names(line.substr(std::string(kHeader).size()));
  std::vector<std::string> images;
  while (names >> name) images.push_back(name);
  Recorded recorded;
  while (std::getline(file, line)) {
    std::istringstream columns(line);
    Case one;
    columns >> one.operation >> one.border;
    for (const std::string& image : images) {
      Result result;
      if (!(columns >> result)) throw std::runtime_error("truncated: " + line);
      one.image = image;
      if (result != kNone) recorded[one] = result;
    }
  }
  return recorded;
}

}  // namespace thinbench::golden
