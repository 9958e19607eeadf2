// PBM files that stay packed.
#pragma once

#include "images/codecs.hpp"
#include "thinbench/packed.hpp"

namespace thinbench {

/// How packed pixels lie in a file: a header, then rows of packed_row_bytes(width) bytes. 1 is
/// foreground.
struct PackedFormat {
  Index width = 0;
  Index height = 0;
  BitOrder order = BitOrder::msb_first;
  std::size_t header_bytes = 0;

  [[nodiscard]] std::size_t file_bytes() const {
    return header_bytes + static_cast<std::size_t>(packed_row_bytes(width) * height);
  }
};

/// The format of a PBM file (P4). Throws FileError.
[[nodiscard]] PackedFormat pbm_format(const FileBytes& file);

}  // namespace thinbench
