// The lines of a manifest: CSV (RFC 4180, so that names may hold commas, quotes and newlines) or
// one JSON object per line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/text.hpp"
#include "thinbench/image_view.hpp"

namespace thinbench {

/// One page of one input, and what became of it. What is not known or does not apply is not there.
struct BatchRecord {
  std::string file;
  int page = 1;           // from 1
  std::string output;     // relative to the output directory
  std::string operation;  // with the options that change its result
  Index width = 0;        // 0 where the image could not be read, as is the height
  Index height = 0;
  std::optional<std::string> foreground;  // bright or dark
  std::optional<double> threshold;        // bright are grey levels from here on
  std::optional<int> iterations;
  std::optional<std::int64_t> foreground_before;  // pixels of the input's foreground
  std::optional<std::int64_t> foreground_after;   // pixels of the result
  std::optional<std::int64_t> objects;            // of the input's foreground, as are holes
  std::optional<std::int64_t> holes;
  double decode_seconds = 0;
  double compute_seconds = 0;
  double encode_seconds = 0;
  std::string warning;
  std::string error;  // empty where the output was written
};

/// A record that was read back.
struct ManifestLine {
  std::string text;  // as in the file, with its newline
  std::string file;
  std::string output;
  int page = 1;
  std::string operation;
  bool failed = false;
};

struct ManifestText {
  std::vector<ManifestLine> lines;
  std::size_t size = 0;  // bytes up to the end of the last line that is complete
};

/// Throws std::runtime_error where the format cannot hold the name of a file.
void check_name(const std::string& name, TableFormat format);

/// What comes before the first record: the names of the columns; nothing for JSON.
[[nodiscard]] std::string manifest_head(TableFormat format);

[[nodiscard]] std::string manifest_line(const BatchRecord& record, TableFormat format);

/// Ignores a truncated last line. Throws std::runtime_error where the text is no manifest.
[[nodiscard]] ManifestText parse_manifest(std::string_view text, TableFormat format);

}  // namespace thinbench
