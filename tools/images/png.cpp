#include <bit>
#include <csetjmp>
#include <cstring>
#include <new>
#include <vector>

#include <fmt/format.h>
#include <png.h>

#include "images/codecs.hpp"

namespace thinbench {
namespace {

/// What libpng reads or writes, and what it said when it gave up.
struct PngStream {
  std::string_view rest;
  std::string written;
  std::string error;
};

void keep_error(png_structp png, png_const_charp text) {
  static_cast<PngStream*>(png_get_error_ptr(png))->error = text;
  png_longjmp(png, 1);
}

void ignore_warning(png_structp /*png*/, png_const_charp /*text*/) {}

void read_bytes(png_structp png, png_bytep to, std::size_t count) {
  auto& stream = *static_cast<PngStream*>(png_get_io_ptr(png));
  if (count > stream.rest.size()) png_error(png, "the file is truncated");
  std::memcpy(to, stream.rest.data(), count);
  stream.rest.remove_prefix(count);
}

void write_bytes(png_structp png, png_bytep from, std::size_t count) {
  auto& stream = *static_cast<PngStream*>(png_get_io_ptr(png));
  bool is_written = true;
  try {
    stream.written.append(reinterpret_cast<const char*>(from), count);
  } catch (const std::bad_alloc&) {
    is_written = false;
  }
  if (!is_written) png_error(png, "out of memory");
}

void flush(png_structp /*png*/) {}

/// Does a step of libpng's; false after an error. The step makes nothing that must be destroyed.
template <class Step>
bool succeeds(png_structp png, const Step& step) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT(cert-err52-cpp): libpng knows no other
  step();
  return true;
}

class PngReader {
 public:
  explicit PngReader(std::string_view bytes) : stream_{bytes, {}, {}} {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &stream_, keep_error, ignore_warning);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
    if (info_ == nullptr) throw std::bad_alloc();
    png_set_read_fn(png_, &stream_, read_bytes);
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  Pixels decode(const Decoding& request, std::size_t size) {
    check(succeeds(png_, [this] { png_read_info(png_, info_); }));
    const Index width = png_get_image_width(png_, info_),
                height = png_get_image_height(png_, info_);
    const int bits = png_get_bit_depth(png_, info_) * png_get_channels(png_, info_);
    constexpr Index deflate_factor = 1032;  // bytes that one byte can stand for, at most
    check_claim(width, height, bytes_of_rows(width, height, bits) / deflate_factor, size);
    check(succeeds(png_, [&] { set_transforms(request.as_stored); }));
    const bool is_deep = png_get_bit_depth(png_, info_) == 16;
    Pixels image = make_pixels(width, height, png_get_channels(png_, info_),
                               is_deep ? SampleKind::u16 : SampleKind::u8);
    check(succeeds(png_, [&] { read_rows(image); }));
    if (has_palette() && !request.as_stored) image = through_palette(image, palette());
    return turned(std::move(image), orientation());
  }

 private:
  void check(bool succeeded) const {
    if (succeeded) return;
    if (stream_.error.find("emory") != std::string::npos) throw std::bad_alloc();
    throw DecodeError("it is damaged: " + stream_.error);
  }

  [[nodiscard]] bool has_palette() const {
    return png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE;
  }

  /// To whole bytes or 16 bits in this machine's order, with opacity where one colour stands for
  /// what is transparent.
  void set_transforms(bool as_stored) {
    const bool is_grey = png_get_color_type(png_, info_) == PNG_COLOR_TYPE_GRAY;
    png_set_packing(png_);
    if (is_grey && !as_stored) png_set_expand_gray_1_2_4_to_8(png_);
    const bool has_colour = png_get_valid(png_, info_, PNG_INFO_tRNS) != 0 && !has_palette();
    if (has_colour && !as_stored) png_set_tRNS_to_alpha(png_);
    if constexpr (std::endian::native == std::endian::little) png_set_swap(png_);
    passes_ = png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
  }

  void read_rows(const Pixels& image) {
    for (int pass = 0; pass < passes_; ++pass) {
      for (Index y = 0; y < image.height; ++y) png_read_row(png_, image.row(y), nullptr);
    }
    png_read_end(png_, info_);
  }

  [[nodiscard]] std::vector<PaletteColour> palette() const {
    png_colorp colours = nullptr;
    png_bytep opacities = nullptr;
    int count = 0, opacity_count = 0;
    png_get_PLTE(png_, info_, &colours, &count);
    png_get_tRNS(png_, info_, &opacities, &opacity_count, nullptr);
    std::vector<PaletteColour> found;
    for (int i = 0; i < count; ++i) {
      const png_byte opacity = i < opacity_count ? opacities[i] : png_byte{255};
      found.push_back({colours[i].red, colours[i].green, colours[i].blue, opacity});
    }
    return found;
  }

  [[nodiscard]] int orientation() const {
    png_bytep exif = nullptr;
    png_uint_32 size = 0;
    if (png_get_eXIf_1(png_, info_, &size, &exif) == 0) return 1;
    return exif_orientation({reinterpret_cast<const char*>(exif), size});
  }

  PngStream stream_;
  png_structp png_;
  png_infop info_;
  int passes_ = 1;
};

void write_image(png_structp png, png_infop info, const Samples& image) {
  const int bits = image.kind == SampleKind::u16 ? 16 : 8;
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), bits,
               image.channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  if constexpr (std::endian::native == std::endian::little) png_set_swap(png);
  for (Index y = 0; y < image.height; ++y) png_write_row(png, image.row(y));
  png_write_end(png, info);
}

}  // namespace

Pixels decode_png(std::string_view bytes, const Decoding& request) {
  return PngReader(bytes).decode(request, bytes.size());
}

std::string encode_png(const Samples& image) {
  PngStream stream;
  png_structp png =
      png_create_write_struct(PNG_LIBPNG_VER_STRING, &stream, keep_error, ignore_warning);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  const bool is_written = info != nullptr && succeeds(png, [&] {
                            png_set_write_fn(png, &stream, write_bytes, flush);
                            png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
                            // Large images of few levels: fast, and as small as by more effort.
                            png_set_compression_level(png, 1);
                            png_set_compression_strategy(png, 3);  // Z_RLE
                            png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
                            write_image(png, info, image);
                          });
  png_destroy_write_struct(&png, &info);
  if (!is_written) throw std::bad_alloc();  // all else was checked
  return std::move(stream.written);
}

}  // namespace thinbench
