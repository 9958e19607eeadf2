#include "images/tiff.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <new>
#include <vector>

#include <fmt/format.h>

#include "images/geo_tiff.hpp"
#include "images/tiff_handle.hpp"

namespace thinbench {
namespace {

using namespace std::string_view_literals;

constexpr Index kMaxTileSide = 2048;  // of small images
constexpr int kMinIsWhite = PHOTOMETRIC_MINISWHITE;

/// What the tags of a page say of its samples.
struct Layout {
  Index width, height;
  int bits, samples, format, photometric, compression;
  bool is_planar, is_tiled;
  Index block_width, block_height;  // of tiles; strips are as wide as the image
  int opacity;                      // the kind of the sample that is one, if there is one
  int opacity_sample;               // its place in a pixel

  [[nodiscard]] int colours() const {
    return photometric == PHOTOMETRIC_SEPARATED                                 ? 4
           : photometric == PHOTOMETRIC_RGB || photometric == PHOTOMETRIC_YCBCR ? 3
                                                                                : 1;
  }
  [[nodiscard]] bool has_opacity() const {
    return opacity == EXTRASAMPLE_ASSOCALPHA || opacity == EXTRASAMPLE_UNASSALPHA;
  }
  /// The sample that is a channel of the image.
  [[nodiscard]] Index sample_of(Index channel) const {
    return channel < colours() ? channel : opacity_sample;
  }
  [[nodiscard]] int channels() const { return colours() + (has_opacity() ? 1 : 0); }
  /// Samples of a pixel in one block.
  [[nodiscard]] int samples_together() const { return is_planar ? 1 : samples; }
  [[nodiscard]] Index block_row_bytes() const {
    return bytes_of_rows(block_width, 1, Index{bits} * samples_together());
  }
  [[nodiscard]] bool is_signed() const { return format == SAMPLEFORMAT_INT; }
  [[nodiscard]] bool is_real() const { return format == SAMPLEFORMAT_IEEEFP; }
};

Layout layout_of(const TiffHandle& tiff) {
  Layout layout{};
  layout.width = tiff.long_number(TIFFTAG_IMAGEWIDTH);
  layout.height = tiff.long_number(TIFFTAG_IMAGELENGTH);
  layout.bits = tiff.number(TIFFTAG_BITSPERSAMPLE, 1);
  layout.samples = tiff.number(TIFFTAG_SAMPLESPERPIXEL, 1);
  layout.format = tiff.number(TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  if (layout.format == SAMPLEFORMAT_VOID) layout.format = SAMPLEFORMAT_UINT;
  layout.photometric = tiff.number(TIFFTAG_PHOTOMETRIC,
                                   layout.samples >= 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
  layout.compression = tiff.number(TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  layout.is_planar =
      tiff.number(TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) == PLANARCONFIG_SEPARATE &&
      layout.samples > 1;
  layout.is_tiled = TIFFIsTiled(tiff.get()) != 0;
  layout.block_width = layout.is_tiled ? tiff.long_number(TIFFTAG_TILEWIDTH) : layout.width;
  layout.block_height = layout.is_tiled
                            ? tiff.long_number(TIFFTAG_TILELENGTH)
                            : std::min(tiff.long_number(TIFFTAG_ROWSPERSTRIP), layout.height);
  std::uint16_t count = 0;
  std::uint16_t* kinds = nullptr;
  TIFFGetField(tiff.get(), TIFFTAG_EXTRASAMPLES, &count, &kinds);
  const auto* const opacity = std::find_if(kinds, kinds + count, [](std::uint16_t kind) {
    return kind == EXTRASAMPLE_ASSOCALPHA || kind == EXTRASAMPLE_UNASSALPHA;
  });
  layout.opacity_sample = layout.samples - count + static_cast<int>(opacity - kinds);
  const bool is_there = opacity != kinds + count && layout.opacity_sample >= layout.colours();
  layout.opacity = is_there ? *opacity : EXTRASAMPLE_UNSPECIFIED;
  return layout;
}

/// A lower bound of what rows of so many bytes take where they are compressed, 0 if unknown.
Index min_bytes(int compression, Index bytes, Index rows) {
  switch (compression) {
    case COMPRESSION_NONE:
      return bytes;
    case COMPRESSION_PACKBITS:
      return bytes / 64;  // two bytes stand for up to 128
    case COMPRESSION_LZW:
      return bytes / 4096;  // nine bits for a table's longest text
    case COMPRESSION_DEFLATE:
    case COMPRESSION_ADOBE_DEFLATE:
      return bytes / 1040;  // two bits for up to 258 bytes
    default:
      return is_ccitt(compression) ? rows / 8 : 0;  // a bit for a row like the one before
  }
}

/// Libtiff knows how to convert these to colours of 8 bits, but no other.
bool needs_conversion(const Layout& layout) {
  switch (layout.photometric) {
    case PHOTOMETRIC_YCBCR:
      return layout.compression != COMPRESSION_JPEG;
    case PHOTOMETRIC_CIELAB:
    case PHOTOMETRIC_ICCLAB:
    case PHOTOMETRIC_ITULAB:
    case PHOTOMETRIC_LOGL:
    case PHOTOMETRIC_LOGLUV:
      return true;
    default:
      return layout.compression == COMPRESSION_OJPEG;
  }
}

void check_compression(int compression) {
  if (TIFFIsCODECConfigured(static_cast<std::uint16_t>(compression)) != 0) return;
  const bool is_jpeg_2000 = compression == 33003 || compression == 33005 || compression == 34712;
  throw DecodeError(fmt::format("its compression {}{} is not supported", compression,
                                is_jpeg_2000 ? ", JPEG 2000," : ""));
}

/// Before memory is taken for pixels.
void check_layout(const Layout& layout, std::size_t size) {
  check_compression(layout.compression);
  const auto& [width, height] = std::pair(layout.width, layout.height);
  const bool is_large = std::max(layout.block_width, layout.block_height) > kMaxTileSide;
  if (layout.is_tiled && is_large &&
      (layout.block_width > 2 * width || layout.block_height > 2 * height)) {
    throw DecodeError(fmt::format("its tiles of {} x {} pixels are larger than its {} x {} pixels",
                                  layout.block_width, layout.block_height, width, height));
  }
  const int samples =
      layout.photometric == PHOTOMETRIC_YCBCR ? 1 : layout.samples;  // subsampled chroma
  const Index bytes = bytes_of_rows(width, height, Index{layout.bits} * samples);
  check_claim(width, height, min_bytes(layout.compression, bytes, height), size);
}

void check_samples(const Layout& layout) {
  const auto [bits, is_real] = std::pair(layout.bits, layout.is_real());
  const bool is_known = is_real              ? bits == 32 || bits == 64
                        : layout.is_signed() ? bits == 8 || bits == 16 || bits == 32
                                             : layout.format == SAMPLEFORMAT_UINT &&
                                                   ((bits >= 1 && bits <= 16) || bits == 32);
  if (!is_known) {
    throw DecodeError(fmt::format(
        "its samples are {}s of {} bits; known are integers of 1 to 16 and of 32 bits, and "
        "real numbers of 32 and 64",
        is_real                             ? "real number"
        : layout.format <= SAMPLEFORMAT_INT ? "integer"
                                            : "complex number",
        bits));
  }
  if (layout.samples < layout.colours()) {
    throw DecodeError(fmt::format("its pixels have {} samples, too few for their kind of colours",
                                  layout.samples));
  }
  const bool is_grey_or_colour = layout.photometric <= PHOTOMETRIC_YCBCR;
  if (!is_grey_or_colour) {
    throw DecodeError(
        fmt::format("its photometric interpretation {} is not supported", layout.photometric));
  }
  const bool is_plain =
      layout.photometric == PHOTOMETRIC_MINISBLACK || layout.photometric == PHOTOMETRIC_RGB;
  const bool has_inks = layout.photometric == PHOTOMETRIC_SEPARATED;
  if ((layout.bits > 16 && !is_plain) || (has_inks && layout.bits > 8 && layout.bits < 16)) {
    throw DecodeError(fmt::format("its photometric interpretation {} has {} bits",
                                  layout.photometric, layout.bits));
  }
  if (layout.is_signed() && !is_plain) {
    throw DecodeError(
        fmt::format("its photometric interpretation {} has signed samples", layout.photometric));
  }
}

/// All strips or tiles lie in the file and have the least that their pixels take.
void check_blocks(const TiffHandle& tiff, const Layout& layout) {
  const std::uint32_t count =
      layout.is_tiled ? TIFFNumberOfTiles(tiff.get()) : TIFFNumberOfStrips(tiff.get());
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint64_t offset = TIFFGetStrileOffset(tiff.get(), i), size = tiff.size();
    const std::uint64_t bytes = TIFFGetStrileByteCount(tiff.get(), i);
    if (offset > size || bytes > size - offset) throw DecodeError("the file is truncated");
    if (layout.is_tiled || layout.is_planar || needs_conversion(layout)) continue;
    const Index rows = std::min(layout.block_height, layout.height - i * layout.block_height);
    if (static_cast<Index>(bytes) >=
        min_bytes(layout.compression, rows * layout.block_row_bytes(), rows))
      continue;
    throw DecodeError(
        fmt::format("its strips are too short for {} x {} pixels", layout.width, layout.height));
  }
}

/// The bits of each byte, the highest first, a byte each.
constexpr auto kBitsOf = [] {
  std::array<std::array<std::uint8_t, 8>, 256> bits{};
  for (unsigned byte = 0; byte < 256; ++byte)
    for (unsigned i = 0; i < 8; ++i) bits[byte][i] = byte >> (7 - i) & 1;
  return bits;
}();

void unpack_bits(const std::uint8_t* from, Index count, std::uint8_t* to) {
  for (Index i = 0; i < count; i += 8, ++from)
    std::copy_n(kBitsOf[*from].data(), std::min<Index>(8, count - i), to + i);
}

/// Samples of a row, the first in the highest bits, as numbers.
template <class T>
void unpack(const std::uint8_t* from, Index count, int bits, T* to) {
  if constexpr (std::is_same_v<T, std::uint8_t>) {
    if (bits == 1) return unpack_bits(from, count, to);
  }
  if (bits == 8 * static_cast<int>(sizeof(T))) {
    std::memcpy(to, from, static_cast<std::size_t>(count) * sizeof(T));
  } else {
    std::uint32_t window = 0;
    int filled = 0;
    for (Index i = 0; i < count; ++i) {
      for (; filled < bits; filled += 8) window = window << 8 | *from++;
      filled -= bits;
      to[i] = static_cast<T>(window >> filled & ((1U << bits) - 1));
    }
  }
}

/// Reads strips or tiles into an image of the samples as they are stored.
class BlockReader {
 public:
  BlockReader(const TiffHandle& tiff, const Layout& layout, bool lenient)
      : tiff_(tiff), layout_(layout), lenient_(lenient) {}

  void read_into(Pixels& image) {
    const int planes = layout_.is_planar ? image.channels : 1;
    for (int plane = 0; plane < planes; ++plane) {
      for (Index y = 0; y < layout_.height; y += layout_.block_height) {
        for (Index x = 0; x < layout_.width; x += layout_.block_width)
          read_block(image, x, y, plane);
      }
    }
    image.warning = warning_;
  }

 private:
  void read_block(const Pixels& image, Index x, Index y, int plane) {
    const Index rows = std::min(layout_.block_height, layout_.height - y);
    const Index bytes =
        (layout_.is_tiled ? layout_.block_height : rows) * layout_.block_row_bytes();
    if (is_as_stored(image)) return decode(image.row(y), bytes, x, y, plane);
    if (buffer_.empty())
      buffer_.resize(static_cast<std::size_t>(layout_.block_height * layout_.block_row_bytes()));
    decode(buffer_.data(), bytes, x, y, plane);
    const Index columns = std::min(layout_.block_width, layout_.width - x);
    for (Index row = 0; row < rows; ++row) {
      const std::uint8_t* const from = buffer_.data() + row * layout_.block_row_bytes();
      for_type(image.kind, [&](auto sample) {
        place<decltype(sample)>(from, columns, image, x, y + row, plane);
      });
    }
  }

  /// Whether rows of blocks are rows of the image.
  [[nodiscard]] bool is_as_stored(const Pixels& image) const {
    return !layout_.is_tiled && layout_.block_row_bytes() == image.row_bytes() &&
           (layout_.bits % 8 == 0 || image.kind == SampleKind::bit);
  }

  void decode(std::uint8_t* to, Index bytes, Index x, Index y, int plane) {
    TIFF* const tiff = tiff_.get();
    const auto column = static_cast<std::uint32_t>(x), row = static_cast<std::uint32_t>(y);
    const auto sample = static_cast<std::uint16_t>(layout_.sample_of(plane));
    const tmsize_t got =
        layout_.is_tiled
            ? TIFFReadEncodedTile(tiff, TIFFComputeTile(tiff, column, row, 0, sample), to, bytes)
            : TIFFReadEncodedStrip(tiff, TIFFComputeStrip(tiff, row, sample), to, bytes);
    std::string problem = tiff_.complaint();
    if (problem.empty() && got < bytes) problem = "the file is truncated";
    if (problem.empty()) return;
    if (problem.find("emory") != std::string::npos) throw std::bad_alloc();
    if (!lenient_) throw DecodeError(problem);
    if (warning_.empty()) warning_ = problem;
    const Index valid = std::clamp<Index>(got, 0, bytes);
    std::memset(to + valid, 0, static_cast<std::size_t>(bytes - valid));
  }

  template <class T>
  void place(const std::uint8_t* from, Index columns, const Pixels& image, Index x, Index y,
             int plane) {
    const Index together = layout_.samples_together(), channels = image.channels;
    T* const to = image.samples_of_row<T>(y) + x * channels;
    if (together == channels) return unpack(from, columns * channels, layout_.bits, to);
    row_.resize(static_cast<std::size_t>(columns * together) * sizeof(T));
    T* const samples = reinterpret_cast<T*>(row_.data());
    unpack(from, columns * together, layout_.bits, samples);
    if (layout_.is_planar) {
      for (Index i = 0; i < columns; ++i) to[i * channels + plane] = samples[i];
      return;
    }
    for (Index i = 0; i < columns; ++i) {
      for (Index k = 0; k < channels; ++k)
        to[i * channels + k] = samples[i * together + layout_.sample_of(k)];
    }
  }

  const TiffHandle& tiff_;
  const Layout& layout_;
  bool lenient_;
  std::vector<std::uint8_t> buffer_;  // a block
  std::vector<std::uint8_t> row_;
  std::string warning_;
};

/// Colours of 8 bits as libtiff converts them.
Pixels converted(const TiffHandle& tiff, const Layout& layout) {
  std::array<char, 1024> why{};
  if (TIFFRGBAImageOK(tiff.get(), why.data()) == 0) {
    throw DecodeError("it is of a kind that is not read: " + std::string(why.data()));
  }
  TIFFSetField(tiff.get(), TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  Pixels image = make_pixels(layout.width, layout.height, 3, SampleKind::u8);
  std::vector<std::uint32_t> block(
      static_cast<std::size_t>(layout.block_width * layout.block_height));
  for (Index y = 0; y < layout.height; y += layout.block_height) {
    for (Index x = 0; x < layout.width; x += layout.block_width) {
      const auto column = static_cast<std::uint32_t>(x), row = static_cast<std::uint32_t>(y);
      const int read = layout.is_tiled
                           ? TIFFReadRGBATileExt(tiff.get(), column, row, block.data(), 1)
                           : TIFFReadRGBAStripExt(tiff.get(), row, block.data(), 1);
      if (read != 1 || !tiff.complaint().empty()) {
        throw DecodeError(tiff.complaint().empty() ? "it is damaged" : tiff.complaint());
      }
      const Index rows = std::min(layout.block_height, layout.height - y);
      const Index last =
          (layout.is_tiled ? layout.block_height : rows) - 1;  // the lowest row is first
      for (Index i = 0; i < rows; ++i) {
        const std::uint32_t* from = block.data() + (last - i) * layout.block_width;
        std::uint8_t* to = image.row(y + i) + 3 * x;
        for (Index k = 0; k < std::min(layout.block_width, layout.width - x); ++k, ++from) {
          for (const int shift : {0, 8, 16}) *to++ = static_cast<std::uint8_t>(*from >> shift);
        }
      }
    }
  }
  return image;
}

/// Calls `change` with each sample of a kind.
template <class T, class Change>
void for_each_sample(const Pixels& image, const Change& change) {
  T* const all = image.samples_of_row<T>(0);
  for (Index i = 0; i < image.samples(); ++i) all[i] = change(all[i]);
}

/// Samples up to `max`, of which 0 may be white, become levels up to 255.
void set_levels(const Pixels& image, std::uint32_t max, bool is_white_first) {
  std::array<std::uint8_t, 256> levels{};
  for (std::uint32_t i = 0; i <= max; ++i)
    levels[i] = static_cast<std::uint8_t>((is_white_first ? max - i : i) * 255 / max);
  for_each_sample<std::uint8_t>(image, [&](std::uint8_t v) { return levels[v]; });
}

std::vector<PaletteColour> palette_of(const TiffHandle& tiff, int bits) {
  std::array<std::uint16_t*, 3> maps{};
  if (TIFFGetField(tiff.get(), TIFFTAG_COLORMAP, &maps[0], &maps[1], &maps[2]) != 1) {
    throw DecodeError("it has no palette");
  }
  const std::size_t count = std::size_t{1} << bits;
  bool is_of_8_bits = true;  // as some writers have it
  for (const std::uint16_t* const map : maps) {
    is_of_8_bits =
        is_of_8_bits && std::all_of(map, map + count, [](std::uint16_t v) { return v < 256; });
  }
  std::vector<PaletteColour> palette;
  for (std::size_t i = 0; i < count; ++i) {
    const auto level = [&](std::size_t k) {
      return static_cast<std::uint8_t>(is_of_8_bits ? maps[k][i] : maps[k][i] >> 8);
    };
    palette.push_back({level(0), level(1), level(2), 255});
  }
  return palette;
}

/// Of inks, with opacity where they have it.
template <class T>
Pixels without_inks(const Pixels& inks) {
  constexpr std::uint64_t max = std::numeric_limits<T>::max();
  Pixels image = make_pixels(inks.width, inks.height, inks.channels - 1, inks.kind);
  const T* from = inks.samples_of_row<T>(0);
  T* to = image.samples_of_row<T>(0);
  for (Index i = 0; i < inks.width * inks.height; ++i) {
    const std::uint64_t white = max - from[3];
    for (int k = 0; k < 3; ++k) *to++ = static_cast<T>(white * (max - from[k]) / max);
    if (image.has_opacity()) *to++ = from[4];
    from += inks.channels;
  }
  image.warning = inks.warning;
  return image;
}

/// What the stored samples mean.
Pixels interpreted(Pixels image, const TiffHandle& tiff, const Layout& layout, bool as_stored) {
  const bool is_white_first = layout.photometric == kMinIsWhite;
  if (is_white_first && as_stored) {
    throw DecodeError("labels need 0 as black, and its 0 is white");
  }
  if (as_stored) return image;
  if (layout.photometric == PHOTOMETRIC_PALETTE)
    return through_palette(image, palette_of(tiff, layout.bits));
  if (image.kind >= SampleKind::i8) return image;
  const std::uint32_t max = (1U << layout.bits) - 1;
  if (image.kind == SampleKind::u8 && (layout.bits < 8 || is_white_first)) {
    set_levels(image, max, is_white_first);
  }
  if (image.kind == SampleKind::u16 && is_white_first) {
    for_each_sample<std::uint16_t>(
        image, [=](std::uint16_t v) { return static_cast<std::uint16_t>(max - v); });
  }
  if (layout.photometric != PHOTOMETRIC_SEPARATED) return image;
  return image.kind == SampleKind::u8 ? without_inks<std::uint8_t>(image)
                                      : without_inks<std::uint16_t>(image);
}

SampleKind kind_of(const Layout& layout) {
  const auto of_size = [&](auto... kinds) {
    return std::array{kinds...}[layout.bits <= 8 ? 0U : layout.bits <= 16 ? 1U : 2U];
  };
  if (layout.is_real()) return layout.bits == 32 ? SampleKind::f32 : SampleKind::f64;
  return layout.is_signed() ? of_size(SampleKind::i8, SampleKind::i16, SampleKind::i32)
                            : of_size(SampleKind::u8, SampleKind::u16, SampleKind::u32);
}

void open_page(TiffHandle& tiff, int page) {
  if (tiff.get() == nullptr) throw DecodeError("it is damaged: " + tiff.complaint());
  if (TIFFSetDirectory(tiff.get(), static_cast<tdir_t>(page)) != 1) {
    throw DecodeError(fmt::format("its page {} cannot be read", page + 1));
  }
  tiff.forget_complaints();
}

/// Samples as they are stored.
Pixels stored(const TiffHandle& tiff, const Layout& layout, SampleKind kind, bool lenient) {
  check_size(layout.width, layout.height, kind);
  if (!lenient) check_blocks(tiff, layout);
  Pixels image = make_pixels(layout.width, layout.height, layout.channels(), kind);
  BlockReader(tiff, layout, lenient).read_into(image);
  return image;
}

/// Nothing if the first image is none that stays packed.
std::optional<PackedPage> packed_page(std::string_view bytes) {
  TiffHandle tiff(bytes);
  open_page(tiff, 0);
  const Layout layout = layout_of(tiff);
  const bool is_upright =
      tiff.number(TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT) == ORIENTATION_TOPLEFT;
  if (layout.is_tiled || layout.bits != 1 || layout.samples != 1 || !is_upright ||
      layout.photometric > PHOTOMETRIC_MINISBLACK) {
    return std::nullopt;
  }
  check_compression(layout.compression);
  PackedPage page = {stored(tiff, layout, SampleKind::bit, false), {}};
  page.format = {layout.compression,
                 tiff.number(TIFFTAG_RESOLUTIONUNIT, 2),
                 {tiff.real_number(TIFFTAG_XRESOLUTION), tiff.real_number(TIFFTAG_YRESOLUTION)}};
  const PackedView bits(page.pixels.bytes.get(), layout.width, layout.height, BitOrder::msb_first);
  invert(bits);
  if (layout.photometric == PHOTOMETRIC_MINISBLACK) invert(bits);
  return page;
}

}  // namespace

bool is_tiff(std::string_view bytes) {
  const std::array marks = {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv};  // the last two: BigTIFF
  return std::ranges::any_of(marks, [&](std::string_view mark) { return bytes.starts_with(mark); });
}

std::vector<int> tiff_pages(std::string_view bytes) {
  const TiffHandle tiff(bytes);
  std::vector<int> pages = {0};
  if (tiff.get() == nullptr) return pages;
  const int count = static_cast<int>(TIFFNumberOfDirectories(tiff.get()));
  bool is_read = true;  // else reading the page gives the reason
  for (int page = 1; page < count; ++page) {
    std::uint32_t kind = 0;
    is_read = is_read && TIFFReadDirectory(tiff.get()) == 1;
    if (is_read) TIFFGetField(tiff.get(), TIFFTAG_SUBFILETYPE, &kind);
    if ((kind & (FILETYPE_REDUCEDIMAGE | FILETYPE_MASK)) == 0) pages.push_back(page);
  }
  return pages;
}

Pixels decode_tiff(std::string_view bytes, const Decoding& request) {
  TiffHandle tiff(bytes);
  open_page(tiff, request.page);
  if (tiff.number(TIFFTAG_COMPRESSION) == COMPRESSION_JPEG &&
      tiff.number(TIFFTAG_PHOTOMETRIC) == PHOTOMETRIC_YCBCR) {
    TIFFSetField(tiff.get(), TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
  }
  const Layout layout = layout_of(tiff);
  const int orientation = tiff.number(TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  check_layout(layout, bytes.size());
  if (needs_conversion(layout)) {
    Pixels image = converted(tiff, layout);
    image.place = geo_reference_of(tiff);
    return turned(std::move(image), orientation);
  }
  check_samples(layout);
  Pixels image = stored(tiff, layout, kind_of(layout), request.lenient);
  image = interpreted(std::move(image), tiff, layout, request.as_stored);
  image.nodata = nodata_of(tiff);
  if (layout.bits > 8 && layout.bits < 16) image.highest = (1U << layout.bits) - 1;
  image.shows_black = layout.has_opacity();
  image.is_premultiplied = layout.opacity == EXTRASAMPLE_ASSOCALPHA;
  image.place = geo_reference_of(tiff);
  return turned(std::move(image), orientation);
}

std::optional<PackedPage> decode_packed_tiff(const FileBytes& file) {
  if (!is_tiff(file.text())) return std::nullopt;
  return naming(file, [&] { return packed_page(file.text()); });
}

void invert(const PackedView& image) {
  const Index bytes = packed_row_bytes(image.width);
  const int unused = static_cast<int>(bytes * 8 - image.width);
  for (Index y = 0; y < image.height; ++y) {
    std::uint8_t* const row = image.data + y * image.stride;
    std::transform(row, row + bytes, row,
                   [](std::uint8_t byte) { return static_cast<std::uint8_t>(~byte); });
    row[bytes - 1] = static_cast<std::uint8_t>(row[bytes - 1] & 0xFF << unused);
  }
}

}  // namespace thinbench
