// Manifests of batches, in both formats: their lines, or one line that says what is wrong.
#include <stdexcept>

#include "batch/manifest_text.hpp"
#include "byte_source.hpp"

namespace thinbench {
namespace {

/// The lines, one after the other, are the text up to its last complete line.
void read(std::string_view text, TableFormat format) {
  const ManifestText manifest = parse_manifest(text, format);
  std::string lines;
  for (const ManifestLine& line : manifest.lines) lines += line.text;
  must(manifest.size <= text.size() && text.substr(0, manifest.size).ends_with(lines),
       "the lines of a manifest are others than those of the file");
}

}  // namespace

void try_input(ByteSource& input) {
  const TableFormat format = input.once_in(2) ? TableFormat::csv : TableFormat::json_lines;
  must_succeed_or_explain<std::runtime_error>([&] { read(input.rest(), format); });
}

}  // namespace thinbench
