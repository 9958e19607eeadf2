// The image files of a batch: named one by one, by directories, by patterns and in lists.
#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <vector>

namespace thinbench {

struct BatchInput {
  std::string path;
  /// Of its results: relative to the output directory, without an extension, unless another input
  /// differs in nothing else.
  std::string name;

  friend bool operator==(const BatchInput&, const BatchInput&) = default;
};

struct InputRequest {
  /// Files, directories, patterns with * ? or [ for what does not exist under that name, and "-"
  /// for a list on standard input.
  std::vector<std::string> in;
  bool recursive = false;
  bool null_separated = false;  // the list: one path per NUL instead of per line
  std::string out;              // never searched
};

struct FoundInputs {
  std::vector<BatchInput> inputs;     // sorted, each once
  std::vector<std::string> failures;  // directories that cannot be listed, a line each
  std::size_t skipped_files = 0;      // in directories: without the extension of an image format
  std::size_t skipped_directories = 0;
  bool skipped_out = false;  // it was named, as by the pattern * in a second run
};

/// Files that are named need not exist: reading them gives the reason. In directories, files with
/// the extension of an image format are inputs unless they are hidden. Throws std::runtime_error
/// for a pattern that no file matches, and where there is no input but in `out`.
[[nodiscard]] FoundInputs find_inputs(const InputRequest& request, std::istream& list);

}  // namespace thinbench
