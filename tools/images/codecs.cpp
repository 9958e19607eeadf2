#include "images/codecs.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "images/tiff.hpp"
#include "support/text.hpp"

namespace thinbench {
namespace {

using namespace std::string_view_literals;

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

Pixels decode_known(std::string_view bytes, const Decoding& request) {
  if (bytes.empty()) throw DecodeError("the file is empty");
  if (bytes.starts_with("\x89PNG\r\n\x1A\n"sv)) return decode_png(bytes, request);
  if (bytes.starts_with("\xFF\xD8"sv)) return decode_jpeg(bytes, request);
  if (bytes.starts_with("BM"sv)) return decode_bmp(bytes, request);
  if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '7') {
    return decode_pnm(bytes, request);
  }
  if (is_tiff(bytes)) return decode_tiff(bytes, request);
  const std::string_view name = foreign_format(bytes);
  if (name.empty()) throw DecodeError("it is not an image of a known format");
  throw DecodeError(fmt::format("it is a {} file, which is not read; convert it to PNG", name));
}

}  // namespace

Pixels decode(const FileBytes& file, const Decoding& request) {
  return naming(file, [&] { return decode_known(file.text(), request); });
}

std::vector<int> pages_in(const FileBytes& file) {
  return is_tiff(file.text()) ? tiff_pages(file.text()) : std::vector<int>{0};
}

}  // namespace thinbench
