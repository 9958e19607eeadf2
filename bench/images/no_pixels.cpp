#include "picture/no_pixels.hpp"

#include <fstream>
#include <limits>
#include <sstream>

namespace thinbench {
namespace {

/// The first bytes of a file, as many as sizes are found in.
std::string beginning_of(const std::string& path) {
  std::string bytes(1024, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

/// Whether one of two adjacent 32-bit numbers is 0, in either byte order.
bool has_zero(const std::string& bytes, std::size_t at) {
  const std::string zero(4, '\0');
  return bytes.size() >= at + 8 && (bytes.substr(at, 4) == zero || bytes.substr(at + 4, 4) == zero);
}

/// A whole number, white space and comments before it left out; -1 where there is none.
long next_number(std::istream& text) {
  while ((text >> std::ws).peek() == '#') {
    text.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  long number = -1;
  return text >> number ? number : -1;
}

bool pnm_has_zero(const std::string& bytes) {
  std::istringstream text(bytes.substr(2));
  const long width = next_number(text);
  const long height = next_number(text);
  return width == 0 || height == 0;
}

}  // namespace

bool declares_no_pixels(const std::string& path) {
  const std::string bytes = beginning_of(path);
  const auto begins_with = [&](const char* magic) { return bytes.rfind(magic, 0) == 0; };
  constexpr std::size_t kPngSize = 16;
  constexpr std::size_t kBmpSize = 18;
  if (begins_with("\x89PNG\r\n")) return has_zero(bytes, kPngSize);
  if (begins_with("BM")) return has_zero(bytes, kBmpSize);
  const bool is_pnm = bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6';
  return is_pnm && pnm_has_zero(bytes);
}

}  // namespace thinbench
