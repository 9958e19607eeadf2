// Headers of PBM, PGM, PPM and PAM files.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "thinbench/image_view.hpp"

namespace thinbench {

/// More bytes than any usual header has.
inline constexpr std::size_t kPnmHeaderBytes = 4096;

/// Reads the numbers of a header, which begins with 'P' and a digit.
class PnmHeader {
 public:
  explicit PnmHeader(std::string_view text) : text_(text) {}

  /// The next number; nothing if there is none.
  [[nodiscard]] std::optional<Index> number();

  /// The header with the one space that ends it; nothing if another character follows.
  [[nodiscard]] std::optional<std::string> whole() const;

 private:
  void skip_spaces_and_comments();

  std::string_view text_;
  std::size_t position_ = 2;  // after "P4"
};

}  // namespace thinbench
