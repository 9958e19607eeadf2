#include <array>
#include <csetjmp>
#include <cstdio>  // needed by jpeglib.h
#include <new>
#include <vector>

#include <jerror.h>
#include <jpeglib.h>

#include "images/codecs.hpp"

namespace thinbench {
namespace {

/// What libjpeg said first, of damage that it filled up or at the end.
struct JpegErrors {
  jpeg_error_mgr manager;  // the first member: libjpeg knows this one
  std::jmp_buf jump;
  std::array<char, JMSG_LENGTH_MAX> text;
  bool is_truncated;
  bool is_out_of_memory;
};

JpegErrors& errors_of(j_common_ptr jpeg) {
  return *reinterpret_cast<JpegErrors*>(jpeg->err);
}

void give_up(j_common_ptr jpeg) {
  JpegErrors& errors = errors_of(jpeg);
  errors.is_out_of_memory = errors.manager.msg_code == JERR_OUT_OF_MEMORY;
  errors.manager.format_message(jpeg, errors.text.data());
  std::longjmp(errors.jump, 1);  // NOLINT(cert-err52-cpp): libjpeg knows no other way
}

void keep_warning(j_common_ptr jpeg, int level) {
  JpegErrors& errors = errors_of(jpeg);
  if (level >= 0 || errors.manager.num_warnings++ > 0) return;
  errors.is_truncated = errors.manager.msg_code == JWRN_JPEG_EOF;
  errors.manager.format_message(jpeg, errors.text.data());
}

class JpegReader {
 public:
  explicit JpegReader(std::string_view bytes) : size_(bytes.size()) {
    jpeg_.err = jpeg_std_error(&errors_.manager);
    errors_.manager.error_exit = give_up;
    errors_.manager.emit_message = keep_warning;
    check(succeeds([&] {
      jpeg_create_decompress(&jpeg_);
      jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(bytes.data()),
                   static_cast<unsigned long>(bytes.size()));
      jpeg_save_markers(&jpeg_, JPEG_APP0 + 1, 0xFFFF);
      jpeg_read_header(&jpeg_, TRUE);
    }));
  }
  ~JpegReader() { jpeg_destroy_decompress(&jpeg_); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;

  Pixels decode(bool lenient) {
    if (jpeg_.arith_code != 0) throw DecodeError("it is a JPEG file with arithmetic coding");
    constexpr Index pixels_of_a_byte = 512;  // a bit for a block of 8 x 8 pixels, at least
    const Index width = jpeg_.image_width, height = jpeg_.image_height;
    check_claim(width, height, width * height / pixels_of_a_byte, size_);
    const bool is_cmyk = jpeg_.num_components == 4;
    jpeg_.out_color_space = is_cmyk                     ? JCS_CMYK
                            : jpeg_.num_components == 1 ? JCS_GRAYSCALE
                                                        : JCS_RGB;
    Pixels image = make_pixels(width, height, jpeg_.num_components == 1 ? 1 : 3, SampleKind::u8);
    row_.resize(is_cmyk ? static_cast<std::size_t>(4 * width) : 0);
    const int turn = orientation();  // markers are freed at the end
    check(succeeds([&] { read_rows(image); }));
    image.warning = warning();
    if (!image.warning.empty() && !lenient) throw DecodeError(image.warning);
    return turned(std::move(image), turn);
  }

 private:
  /// The step makes nothing that must be destroyed.
  template <class Step>
  bool succeeds(const Step& step) {
    if (setjmp(errors_.jump) != 0) return false;  // NOLINT(cert-err52-cpp)
    step();
    return true;
  }

  void check(bool succeeded) {
    if (succeeded) return;
    const bool is_out_of_memory = errors_.is_out_of_memory;
    const std::string text = errors_.text.data();
    jpeg_destroy_decompress(&jpeg_);  // again by the destructor, if there is one to come
    if (is_out_of_memory) throw std::bad_alloc();
    throw DecodeError("its decoder says: " + text);
  }

  void read_rows(const Pixels& image) {
    jpeg_start_decompress(&jpeg_);
    while (jpeg_.output_scanline < jpeg_.output_height) {
      std::uint8_t* const to = image.row(jpeg_.output_scanline);
      JSAMPROW row = row_.empty() ? to : row_.data();
      jpeg_read_scanlines(&jpeg_, &row, 1);
      if (!row_.empty()) write_colours(to);
    }
    jpeg_finish_decompress(&jpeg_);
  }

  /// Adobe's files have 255 for no ink.
  void write_colours(std::uint8_t* to) const {
    const int flip = jpeg_.saw_Adobe_marker != 0 ? 0 : 255;
    for (std::size_t i = 0; i < row_.size(); i += 4) {
      const int white = row_[i + 3] ^ flip;
      for (std::size_t k = 0; k < 3; ++k)
        *to++ = static_cast<std::uint8_t>((row_[i + k] ^ flip) * white / 255);
    }
  }

  /// The decoder fills up what is missing and goes on.
  [[nodiscard]] std::string warning() const {
    if (errors_.manager.num_warnings == 0) return {};
    if (errors_.is_truncated) return "the file is truncated";
    return std::string("its decoder says: ") + errors_.text.data();
  }

  [[nodiscard]] int orientation() const {
    for (const jpeg_marker_struct* marker = jpeg_.marker_list; marker != nullptr;
         marker = marker->next) {
      const std::string_view data(reinterpret_cast<const char*>(marker->data), marker->data_length);
      if (data.starts_with(std::string_view("Exif\0\0", 6))) return exif_orientation(data);
    }
    return 1;
  }

  std::size_t size_;
  JpegErrors errors_{};
  jpeg_decompress_struct jpeg_{};
  std::vector<std::uint8_t> row_;  // of four inks
};

}  // namespace

Pixels decode_jpeg(std::string_view bytes, const Decoding& request) {
  return JpegReader(bytes).decode(request.lenient);
}

}  // namespace thinbench
