#include "images/pnm_header.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <system_error>

namespace thinbench {
namespace {

bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

}  // namespace

std::optional<Index> PnmHeader::number() {
  skip_spaces_and_comments();
  Index value = 0;
  const char* const end = text_.data() + text_.size();
  const auto result = std::from_chars(text_.data() + position_, end, value);
  if (result.ec != std::errc() || result.ptr == end) return std::nullopt;
  position_ = static_cast<std::size_t>(result.ptr - text_.data());
  return value;
}

std::optional<std::string> PnmHeader::whole() const {
  if (position_ >= text_.size() || !is_space(text_[position_])) return std::nullopt;
  return std::string(text_.substr(0, position_ + 1));
}

void PnmHeader::skip_spaces_and_comments() {
  while (position_ < text_.size() && (is_space(text_[position_]) || text_[position_] == '#')) {
    if (text_[position_] == '#') position_ = std::min(text_.find('\n', position_), text_.size());
    if (position_ < text_.size()) ++position_;
  }
}

}  // namespace thinbench
