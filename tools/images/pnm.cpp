#include "images/pnm.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>

namespace thinbench {
namespace {

constexpr const char* kDamaged = "it is damaged or has no pixels";

bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// Reads the numbers of a text, after its first two characters.
class Numbers {
 public:
  explicit Numbers(std::string_view text, std::size_t at = 2) : text_(text), at_(at) {}

  [[nodiscard]] std::optional<Index> next() {
    skip_spaces_and_comments();
    Index value = 0;
    const auto result = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (result.ec != std::errc()) return std::nullopt;
    at_ = static_cast<std::size_t>(result.ptr - text_.data());
    return value;
  }
  /// A character of '0' and '1', which need no spaces between them.
  [[nodiscard]] std::optional<bool> next_bit() {
    skip_spaces_and_comments();
    if (at_ >= text_.size() || (text_[at_] != '0' && text_[at_] != '1')) return std::nullopt;
    return text_[at_++] == '1';
  }
  /// Behind the one space that ends a header; 0 if another character follows.
  [[nodiscard]] std::size_t end_of_header() const {
    return at_ < text_.size() && is_space(text_[at_]) ? at_ + 1 : 0;
  }
  [[nodiscard]] std::size_t position() const { return at_; }

 private:
  void skip_spaces_and_comments() {
    while (at_ < text_.size() && (is_space(text_[at_]) || text_[at_] == '#')) {
      if (text_[at_] == '#') at_ = std::min(text_.find('\n', at_), text_.size());
      if (at_ < text_.size()) ++at_;
    }
  }

  std::string_view text_;
  std::size_t at_;
};

struct Header {
  Index width = 0;
  Index height = 0;
  Index maximum = 1;
  Index channels = 1;
  std::size_t bytes = 0;  // of the header
};

/// The number on the line of a PAM header that begins with this word.
Index pam_number(std::string_view header, std::string_view word) {
  const std::size_t at = header.find(word);
  if (at == std::string_view::npos) return 0;
  return Numbers(header, at + word.size()).next().value_or(0);
}

Header pam_header(std::string_view bytes) {
  constexpr std::string_view end = "\nENDHDR\n";
  const std::size_t at = bytes.substr(0, 4096).find(end);
  if (at == std::string_view::npos) throw DecodeError(kDamaged);
  const std::string_view text = bytes.substr(0, at + 1);
  return {pam_number(text, "\nWIDTH"), pam_number(text, "\nHEIGHT"), pam_number(text, "\nMAXVAL"),
          pam_number(text, "\nDEPTH"), at + end.size()};
}

Header header_of(std::string_view bytes) {
  const char kind = bytes[1];
  if (kind == '7') return pam_header(bytes);
  Numbers numbers(bytes);
  Header header;
  header.width = numbers.next().value_or(0);
  header.height = numbers.next().value_or(0);
  if (kind != '1' && kind != '4') header.maximum = numbers.next().value_or(0);
  header.channels = kind == '3' || kind == '6' ? 3 : 1;
  header.bytes = kind < '4' ? numbers.position() : numbers.end_of_header();
  return header;
}

Index min_bytes(char kind, const Header& header) {
  if (kind == '1' || kind == '4') {
    return bytes_of_rows(header.width, header.height, kind == '1' ? 8 : 1);
  }
  const bool is_text = kind < '4';  // a digit and a space
  const Index bits = is_text || header.maximum > 255 ? 16 : 8;
  return bytes_of_rows(header.width, header.height, bits * header.channels) - (is_text ? 1 : 0);
}

/// 1 is black, or stored.
void read_bits(std::string_view bytes, const Pixels& image, bool is_text, bool as_stored) {
  const std::array<std::uint8_t, 2> levels = {as_stored ? std::uint8_t{0} : std::uint8_t{255},
                                              as_stored ? std::uint8_t{1} : std::uint8_t{0}};
  if (is_text) {
    Numbers digits(bytes, 0);
    for (std::uint8_t& level : std::span(image.row(0), static_cast<std::size_t>(image.samples()))) {
      const std::optional<bool> bit = digits.next_bit();
      if (!bit) throw DecodeError("the file is truncated");
      level = levels[*bit ? 1 : 0];
    }
    return;
  }
  for (Index y = 0; y < image.height; ++y) {
    const char* const from = bytes.data() + y * packed_row_bytes(image.width);
    std::uint8_t* const to = image.row(y);
    for (Index x = 0; x < image.width; ++x) to[x] = levels[from[x / 8] >> (7 - x % 8) & 1];
  }
}

template <class T>
void read_samples(std::string_view bytes, const Pixels& image, bool is_text) {
  T* const to = image.samples_of_row<T>(0);
  const auto count = static_cast<std::size_t>(image.samples());
  if (!is_text) {
    bytes.copy(reinterpret_cast<char*>(to), count * sizeof(T));
    if constexpr (sizeof(T) == 2 && std::endian::native == std::endian::little) {
      std::transform(to, to + count, to, [](T v) { return static_cast<T>(v << 8 | v >> 8); });
    }
    return;
  }
  Numbers numbers(bytes, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<Index> number = numbers.next();
    if (!number) throw DecodeError("the file is truncated");
    to[i] = static_cast<T>(std::clamp<Index>(*number, 0, std::numeric_limits<T>::max()));
  }
}

/// The maximum becomes 255, rounded down.
void scale(const Pixels& image, Index maximum) {
  std::array<std::uint8_t, 256> table{};
  for (Index v = 0; v < 256; ++v) {
    table[static_cast<std::size_t>(v)] =
        static_cast<std::uint8_t>(255 * std::min(v, maximum) / maximum);
  }
  std::uint8_t* const all = image.bytes.get();
  std::transform(all, all + image.samples(), all, [&](std::uint8_t v) { return table[v]; });
}

}  // namespace

Pixels decode_pnm(std::string_view bytes, const Decoding& request) {
  const char kind = bytes[1];
  const Header header = header_of(bytes);
  const bool is_text = kind < '4';
  if (header.width < 1 || header.height < 1 || header.bytes == 0 || header.maximum < 1 ||
      header.maximum > 65535 || header.channels < 1 || header.channels > 4) {
    throw DecodeError(kDamaged);
  }
  const auto header_bytes = static_cast<Index>(header.bytes);
  const Index needed = std::min(min_bytes(kind, header), INT64_MAX - header_bytes) + header_bytes;
  check_claim(header.width, header.height, needed, bytes.size());
  Pixels image = make_pixels(header.width, header.height, static_cast<int>(header.channels),
                             header.maximum > 255 ? SampleKind::u16 : SampleKind::u8);
  if (image.kind == SampleKind::u16) image.highest = static_cast<std::uint32_t>(header.maximum);
  const std::string_view data = bytes.substr(header.bytes);
  if (kind == '1' || kind == '4') {
    read_bits(data, image, is_text, request.as_stored);
  } else if (image.kind == SampleKind::u16) {
    read_samples<std::uint16_t>(data, image, is_text);
  } else {
    read_samples<std::uint8_t>(data, image, is_text);
    if (header.maximum != 255 && !request.as_stored) scale(image, header.maximum);
  }
  return image;
}

PackedFormat pbm_format(const FileBytes& file) {
  const std::string& name = file.name();
  if (!file.text().starts_with("P4"))
    cannot_read(name, "it is not a binary PBM file (P4), as OUT requires");
  Numbers numbers(file.text());
  const std::optional<Index> width = numbers.next(), height = numbers.next();
  const std::size_t end = numbers.end_of_header();
  if (!width || !height || end == 0) cannot_read(name, "its PBM header is damaged");
  constexpr Index max_side = Index{1} << 40;
  if (*width < 1 || *height < 1 || *width > max_side || *height > max_side / *width) {
    cannot_read(name,
                fmt::format("its size is {} x {}; expected 1 to 2^40 pixels", *width, *height));
  }
  return {*width, *height, BitOrder::msb_first, end};
}

namespace {

std::string with_header(const std::string& header, Index row_bytes, Index height) {
  std::string bytes = header;
  bytes.reserve(header.size() + static_cast<std::size_t>(row_bytes * height));
  return bytes;
}

}  // namespace

std::string encode_pgm(const Samples& image) {
  const bool is_deep = image.kind == SampleKind::u16;
  std::string bytes =
      with_header(fmt::format("P5\n{} {}\n{}\n", image.width, image.height, is_deep ? 65535 : 255),
                  image.row_bytes(), image.height);
  for (Index y = 0; y < image.height; ++y) {
    const auto* const row = reinterpret_cast<const char*>(image.row(y));
    const auto start = static_cast<std::ptrdiff_t>(bytes.size());
    bytes.append(row, static_cast<std::size_t>(image.row_bytes()));
    if (!is_deep || std::endian::native == std::endian::big) continue;
    for (auto at = bytes.begin() + start; at != bytes.end(); at += 2) std::swap(at[0], at[1]);
  }
  return bytes;
}

std::string encode_pbm(const Samples& image) {
  const Index row_bytes = packed_row_bytes(image.width);
  std::string bytes =
      with_header(fmt::format("P4\n{} {}\n", image.width, image.height), row_bytes, image.height);
  for (Index y = 0; y < image.height; ++y) {
    const std::uint8_t* const row = image.row(y);
    for (Index x = 0; x < image.width; x += 8) {
      int byte = 0;
      for (Index bit = 0; bit < std::min<Index>(8, image.width - x); ++bit) {
        byte |= row[x + bit] == 0 ? 0x80 >> bit : 0;  // 1 is black
      }
      bytes += static_cast<char>(byte);
    }
  }
  return bytes;
}

}  // namespace thinbench
