#include "images/image_header.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "images/image_file.hpp"
#include "images/pnm_header.hpp"
#include "images/tiff_file.hpp"
#include "support/regular_file.hpp"

namespace thinbench {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kLongHeaderBytes = std::size_t{1} << 20;  // may begin with other data
constexpr Index kDeflateFactor = 1032;      // bytes that one byte can stand for, at most
constexpr Index kMaxSide = Index{1} << 20;  // that OpenCV reads
constexpr Index kJpegPixels = 512;          // a bit for a block of 8 x 8 pixels, at least

constexpr std::string_view kPng = "\x89PNG\r\n\x1A\n"sv;

/// An unsigned number of `count` bytes; 0 behind the end.
Index number_at(std::string_view bytes, std::size_t at, std::size_t count, bool is_big_endian) {
  if (at + count > bytes.size()) return 0;
  Index value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = is_big_endian ? at + i : at + count - 1 - i;
    value = value << 8 | static_cast<std::uint8_t>(bytes[next]);
  }
  return value;
}

/// 0 if one is negative, as in a damaged header; the largest number where it is larger.
Index product(Index a, Index b) {
  if (a <= 0 || b <= 0) return 0;
  return a > INT64_MAX / b ? INT64_MAX : a * b;
}

/// The bytes of rows that are padded to whole bytes.
Index bytes_of_rows(Index width, Index height, Index bits_per_pixel) {
  const Index bits = product(width, bits_per_pixel);
  return product(bits / 8 + (bits % 8 != 0 ? 1 : 0), height);
}

ImageClaim png_claim(std::string_view bytes) {
  constexpr std::array<Index, 7> samples = {1, 0, 3, 1, 2, 0, 4};  // by the type of colours
  const Index width = number_at(bytes, 16, 4, true), height = number_at(bytes, 20, 4, true);
  const auto colours = static_cast<std::size_t>(number_at(bytes, 25, 1, true));
  const Index bits = number_at(bytes, 24, 1, true) * (colours < 7 ? samples[colours] : 0);
  return {width, height, bytes_of_rows(width, height, bits) / kDeflateFactor};
}

bool is_bmp_of_os2(std::string_view bytes) {
  return number_at(bytes, 14, 4, false) == 12;
}

Index bmp_bits(std::string_view bytes) {
  return number_at(bytes, is_bmp_of_os2(bytes) ? 24 : 28, 2, false);
}

ImageClaim bmp_claim(std::string_view bytes) {
  const auto number = [&](std::size_t at, std::size_t count) {
    return number_at(bytes, at, count, false);
  };
  if (is_bmp_of_os2(bytes)) {
    const Index width = number(18, 2), height = number(20, 2);
    return {width, height, bytes_of_rows(width, height, bmp_bits(bytes))};
  }
  const Index width = number(18, 4);
  const auto height = static_cast<std::int32_t>(number(22, 4));  // negative: from the top down
  const Index rows = height < 0 ? -Index{height} : height;
  const bool has_runs = number(30, 4) == 1 || number(30, 4) == 2;
  return {width, rows, has_runs ? 0 : bytes_of_rows(width, rows, bmp_bits(bytes))};
}

ImageClaim jpeg_claim(std::string_view bytes, const std::string& path) {
  for (std::size_t at = 2; at + 4 <= bytes.size() && bytes[at] == '\xFF';) {
    const Index marker = number_at(bytes, at + 1, 1, true);
    if (marker == 0xFF) {  // fills up
      ++at;
      continue;
    }
    const bool is_frame = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8;
    if (is_frame && marker != 0xCC) {
      if (marker > 0xC8) cannot_read(path, "it is a JPEG file with arithmetic coding");
      const Index width = number_at(bytes, at + 7, 2, true),
                  height = number_at(bytes, at + 5, 2, true);
      return {width, height, width * height / kJpegPixels};
    }
    at += 2 + static_cast<std::size_t>(number_at(bytes, at + 2, 2, true));
  }
  return {};
}

/// A number in a line of a PAM header; 0 if there is none.
Index pam_number(std::string_view header, std::string_view name) {
  const std::size_t at = header.find(name);
  if (at == std::string_view::npos) return 0;
  return PnmHeader(header.substr(at + name.size() - 2)).number().value_or(0);
}

ImageClaim pnm_claim(std::string_view header) {
  const char kind = header[1];
  if (kind == '7') {
    const Index width = pam_number(header, "\nWIDTH"), height = pam_number(header, "\nHEIGHT");
    const Index bits = pam_number(header, "\nMAXVAL") > 255 ? 16 : 8;
    return {width, height,
            bytes_of_rows(width, height, product(bits, pam_number(header, "\nDEPTH")))};
  }
  PnmHeader numbers(header);
  const Index width = numbers.number().value_or(0), height = numbers.number().value_or(0);
  if (kind == '1' || kind == '4') {
    return {width, height, bytes_of_rows(width, height, kind == '1' ? 8 : 1)};
  }
  const bool is_text = kind < '4';
  const Index bytes = is_text || numbers.number().value_or(0) > 255 ? 2 : 1;  // a digit and a space
  const Index samples = kind == '3' || kind == '6' ? 3 : 1;
  return {width, height, bytes_of_rows(width, height, 8 * bytes * samples) - (is_text ? 1 : 0)};
}

/// Nothing for other kinds of files.
std::optional<ImageClaim> claim_of(const std::string& path, int page) {
  const std::string bytes = beginning_of(path, kPnmHeaderBytes);
  const std::string_view start = bytes;
  if (start.starts_with(kPng)) return png_claim(start);
  if (start.starts_with("\xFF\xD8"sv))
    return jpeg_claim(beginning_of(path, kLongHeaderBytes), path);
  if (start.starts_with("BM"sv)) return bmp_claim(start);
  if (start.size() > 2 && start[0] == 'P' && start[1] >= '1' && start[1] <= '7') {
    return pnm_claim(start);
  }
  if (is_tiff(path)) return tiff_claim(path, page);
  return std::nullopt;
}

/// The name of a format that is not read; empty if this is none.
std::string_view foreign_format(std::string_view start) {
  if (start.starts_with("GIF87a"sv) || start.starts_with("GIF89a"sv)) return "GIF";
  const std::string_view kind = start.substr(std::min<std::size_t>(8, start.size()));
  if (start.starts_with("RIFF"sv) && kind.starts_with("WEBP"sv)) return "WebP";
  if (start.starts_with("\0\0\0\x0CjP  "sv) || start.starts_with("\xFF\x4F\xFF\x51"sv))
    return "JPEG 2000";
  if (start.starts_with("%PDF"sv)) return "PDF";
  if (start.starts_with("<svg"sv)) return "SVG";
  if (kind.size() < 4 || start.substr(4, 4) != "ftyp"sv) return {};
  return kind.starts_with("avif"sv) ? "AVIF" : "HEIF";
}

/// The data of a PNG file's chunk of this name that comes before its pixels; empty if there is
/// none.
std::string_view png_chunk(std::string_view bytes, std::string_view name) {
  for (std::size_t at = kPng.size(); at + 8 <= bytes.size();) {
    const auto size = static_cast<std::size_t>(number_at(bytes, at, 4, true));
    const std::string_view found = bytes.substr(at + 4, 4);
    if (found == name) return bytes.substr(at + 8, size);
    if (found == "IDAT"sv) break;
    at += size + 12;
  }
  return {};
}

/// Levels of `bits` bits as the decoder gives them.
double decoded_level(Index level, Index bits) {
  return static_cast<double>(bits < 8 ? level * 255 / ((Index{1} << bits) - 1) : level);
}

}  // namespace

std::optional<TransparentColour> png_transparency(const std::string& path) {
  constexpr Index colour = 2, grey_alpha = 4, colour_alpha = 6;
  if (!beginning_of(path, kPng.size()).starts_with(kPng)) return std::nullopt;
  const std::string bytes = beginning_of(path, kLongHeaderBytes);
  const Index kind = number_at(bytes, 25, 1, true), bits = number_at(bytes, 24, 1, true);
  if (kind == grey_alpha || kind == colour_alpha) return TransparentColour();
  const std::string_view levels = png_chunk(bytes, "tRNS");
  if (levels.empty()) return std::nullopt;
  const auto level = [&](std::size_t i) {
    return decoded_level(number_at(levels, 2 * i, 2, true), bits);
  };
  if (kind == 0) return TransparentColour{level(0)};
  return kind == colour ? TransparentColour{level(2), level(1), level(0)} : TransparentColour();
}

void check_label_levels(const std::string& path) {
  const std::string start = beginning_of(path, kPnmHeaderBytes);
  Index bits = 8;
  if (start.starts_with(kPng)) bits = number_at(start, 24, 1, true);
  if (start.starts_with("BM"sv)) bits = bmp_bits(start);
  if (start.starts_with("P1"sv) || start.starts_with("P4"sv) || is_bilevel_tiff(path)) bits = 1;
  if (bits < 8) {
    cannot_read(path, fmt::format("labels are one channel of 8 or 16 bits, and it has {}", bits));
  }
  if (is_inverted_tiff(path)) cannot_read(path, "labels need 0 as black, and its 0 is white");
  if (!start.starts_with("P2"sv)) return;
  PnmHeader numbers(start);
  Index maximum = 255;
  for (int i = 0; i < 3; ++i) maximum = numbers.number().value_or(255);
  if (maximum < 255) {
    cannot_read(path,
                fmt::format("labels in PGM text need a maximum of 255 or more, got {}", maximum));
  }
}

void check_header(const std::string& path, int page) {
  const std::optional<ImageClaim> claim = claim_of(path, page);
  if (!claim) {
    const std::string_view name = foreign_format(beginning_of(path, 16));
    if (name.empty()) cannot_read(path, "it is not an image of a known format");
    cannot_read(path, fmt::format("it is a {} file, which is not read; convert it to PNG", name));
  }
  const Index size = regular_file_bytes(path);
  // The decoder says of larger images that they are too large.
  if (claim->width < 1 || claim->height > kMaxImagePixels / claim->width) return;
  if (std::max(claim->width, claim->height) > kMaxSide) return;
  if (claim->min_bytes <= size) return;
  cannot_read(path, fmt::format("it has {} bytes, too few for {} x {} pixels", size, claim->width,
                                claim->height));
}

}  // namespace thinbench
