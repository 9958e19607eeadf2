#include "images/image_file.hpp"

#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "images/grey_image.hpp"
#include "images/tiff.hpp"
#include "support/text.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

template <class T>
LabelPixels labels_of(const Pixels& image, const std::string& path) {
  if constexpr (!std::is_integral_v<T>) {
    cannot_read(path, "labels are whole numbers, and it has real ones");
  } else {
    const T* const all = image.samples_of_row<T>(0);
    const auto [least, greatest] = std::minmax_element(all, all + image.samples());
    if (std::cmp_less(*least, 0))
      cannot_read(path, "labels are not negative, and it has negative numbers");
    if (std::cmp_greater(*greatest, INT32_MAX))
      cannot_read(path, "labels go up to 2^31 - 1, and it has greater ones");
    return {image.width, image.height, std::vector<std::int32_t>(all, all + image.samples()),
            image.place};
  }
}

}  // namespace

LabelPixels read_labels(const FileBytes& file) {
  const std::string& path = file.name();
  const Pixels image = decode(file, {.as_stored = true});
  if (image.channels != 1) {
    cannot_read(path, fmt::format("labels are one channel, and it has {}", image.channels));
  }
  return for_type(image.kind,
                  [&](auto sample) { return labels_of<decltype(sample)>(image, path); });
}

ByteImage read_grey(const std::string& path, int page) {
  Channel channel = Channel::grey;
  std::string ignored;
  return in_bytes(grey_of(decode(read_file(path), {.page = page}), {}, channel, ignored)).bytes;
}

namespace {

/// Throws ExtensionError unless the file has one of these extensions.
void check_among(const std::string& path, std::initializer_list<std::string_view> known) {
  if (path == kStandardStream) return;
  const std::string extension = extension_of(path);
  if (std::ranges::find(known, extension) != known.end()) return;
  const std::string why = extension.empty()     ? "its name has no extension"
                          : extension == ".bmp" ? "BMP holds no 16 bits"
                          : extension == ".pgm" ? "PGM holds no colours"
                          : extension == ".jpg" || extension == ".jpeg"
                              ? "JPEG would change pixels"
                              : "unknown extension '" + extension + "'";
  throw ExtensionError(fmt::format("cannot write '{}': {}; known are {} and {}", path, why,
                                   fmt::join(known.begin(), known.end() - 1, ", "),
                                   *(known.end() - 1)));
}

void check_size(const std::string& path, const std::string& extension, const Samples& image) {
  if (image.width == 0 || image.height == 0) cannot_write(path, "the image has no pixels");
  if (image.width > (kMaxImagePixels - 1) / image.height) {
    cannot_write(path, "the image has 2^31 pixels or more");
  }
  constexpr Index max_png_side = 1'000'000;
  if (extension == ".png" && std::max(image.width, image.height) > max_png_side) {
    cannot_write(path, "PNG has sides of at most 10^6 pixels; .tif and .pgm have no such limit");
  }
  constexpr Index max_bmp_bytes = (Index{1} << 32) - 4096;
  if (extension == ".bmp" && (image.row_bytes() + 3) * image.height > max_bmp_bytes) {
    cannot_write(path, "BMP has at most 2^32 bytes");
  }
}

std::string encoded(const std::string& extension, std::span<const Samples> pages) {
  if (is_tiff_extension(extension)) return encode_tiff(pages);
  const Samples& image = pages.front();
  if (extension == ".pgm") return encode_pgm(image);
  if (extension == ".pbm") return encode_pbm(image);
  return extension == ".bmp" ? encode_bmp(image) : encode_png(image);
}

void write_images(const std::string& path, std::span<const Samples> pages) {
  const std::string extension = path == kStandardStream ? ".png" : extension_of(path);
  for (const Samples& page : pages) check_size(path, extension, page);
  try {
    write_bytes(path, encoded(extension, pages));
  } catch (const std::bad_alloc&) {
    cannot_write(path, "there is not enough memory for it");
  }
}

template <class T>
Samples samples_of(const View<const T>& image, SampleKind kind) {
  return {image.data, image.width, image.height, image.stride * Index{sizeof(T)}, 1, kind};
}

void write_image(const std::string& path, const Samples& image) {
  write_images(path, {&image, 1});
}

}  // namespace

void check_extension(const std::string& path) {
  check_among(path, {".png", ".pgm", ".bmp", ".tif", ".tiff"});
}

void check_deep_extension(const std::string& path) {
  check_among(path, {".png", ".pgm", ".tif", ".tiff"});
}

void check_overlay_extension(const std::string& path) {
  check_among(path, {".svg", ".png", ".bmp", ".tif", ".tiff"});
}

void check_real_extension(const std::string& path) {
  if (path != kStandardStream && is_tiff_extension(extension_of(path))) return;
  throw ExtensionError("cannot write '" + path +
                       "': of real numbers only .tif and .tiff are known");
}

void write_bytes(const std::string& path, std::string_view bytes) {
  if (path != kStandardStream) return write_whole_file(path, bytes);
  const bool is_written = std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size();
  if (!is_written || std::fflush(stdout) != 0) {
    throw FileError("standard output cannot be written");
  }
}

void write_grey(const std::string& path, const ConstImageView& image) {
  check_extension(path);
  write_image(path, samples_of(image, SampleKind::u8));
}

void write_grey_pages(const std::string& path, const std::vector<ByteImage>& pages) {
  std::vector<Samples> all;
  all.reserve(pages.size());
  for (const ByteImage& page : pages) all.push_back(samples_of(page.view(), SampleKind::u8));
  write_images(path, all);
}

void write_binary(const std::string& path, const ConstImageView& image) {
  if (extension_of(path) != ".pbm") check_extension(path);
  write_image(path, samples_of(image, SampleKind::u8));
}

void write_colours(const std::string& path, const std::vector<std::uint8_t>& colours, Index width,
                   Index height) {
  write_image(path, {colours.data(), width, height, 3 * width, 3});
}

void write_deep(const std::string& path, const View<const std::uint16_t>& image) {
  check_deep_extension(path);
  write_image(path, samples_of(image, SampleKind::u16));
}

void write_labels(const std::string& path, const ConstLabelView& labels) {
  check_deep_extension(path);
  std::int32_t greatest = 0;
  for (Index y = 0; y < labels.height; ++y) {
    for (Index x = 0; x < labels.width; ++x) greatest = std::max(greatest, labels.row(y)[x]);
  }
  if (greatest > 65535) {
    if (is_tiff_extension(extension_of(path)))
      return write_image(path, samples_of(labels, SampleKind::u32));
    cannot_write(path,
                 fmt::format("it has labels up to {}, and its format holds 65535; .tif holds more",
                             greatest));
  }
  std::vector<std::uint16_t> deep;
  deep.reserve(static_cast<std::size_t>(labels.width * labels.height));
  for (Index y = 0; y < labels.height; ++y)
    deep.insert(deep.end(), labels.row(y), labels.row(y) + labels.width);
  write_deep(path, {deep.data(), labels.width, labels.height});
}

void write_reals(const std::string& path, const View<const float>& image) {
  check_real_extension(path);
  write_image(path, samples_of(image, SampleKind::f32));
}

std::string png_of(const ConstImageView& image) {
  return encode_png(samples_of(image, SampleKind::u8));
}

}  // namespace thinbench
