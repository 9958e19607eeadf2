// libtiff's handle of a file in memory. Includes libtiff.
#pragma once

#include <cstdarg>
#include <cstdint>
#include <string>
#include <string_view>

#include <tiffio.h>

#include "thinbench/image_view.hpp"

namespace thinbench {

/// A TIFF file in memory, and the first thing that libtiff complained of.
class TiffHandle {
 public:
  /// To read. get() is null where the file cannot be opened.
  explicit TiffHandle(std::string_view bytes);
  /// To write; `mode` as of TIFFOpen.
  explicit TiffHandle(const char* mode);
  ~TiffHandle();
  TiffHandle(const TiffHandle&) = delete;
  TiffHandle& operator=(const TiffHandle&) = delete;

  [[nodiscard]] TIFF* get() const { return tiff_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Empty if there is none; warnings count only from forget_complaints() on: before, they tell of
  /// tags.
  [[nodiscard]] const std::string& complaint() const { return complaint_; }
  void forget_complaints();
  /// Ends the file that was written. Throws std::bad_alloc where memory was short.
  [[nodiscard]] std::string take();

  /// The value of a tag, else its default; `otherwise` if it has none.
  [[nodiscard]] int number(std::uint32_t tag, int otherwise = 0) const {
    std::uint16_t value = 0;
    return TIFFGetFieldDefaulted(tiff_, tag, &value) == 1 ? value : otherwise;
  }
  [[nodiscard]] Index long_number(std::uint32_t tag) const {
    std::uint32_t value = 0;
    return TIFFGetFieldDefaulted(tiff_, tag, &value) == 1 ? value : 0;
  }
  [[nodiscard]] float real_number(std::uint32_t tag) const {
    float value = 0;
    return TIFFGetField(tiff_, tag, &value) == 1 ? value : 0;
  }

 private:
  void open(const char* mode);

  static tmsize_t read(thandle_t self, void* to, tmsize_t count);
  static tmsize_t write(thandle_t self, void* from, tmsize_t count);
  static toff_t seek(thandle_t self, toff_t offset, int whence);
  static int close(thandle_t self);
  static toff_t size_of(thandle_t self);
  static int map(thandle_t self, void** base, toff_t* size);
  static void unmap(thandle_t self, void* base, toff_t size);
  static int keep_error(TIFF*, void* self, const char*, const char* format, std::va_list values);
  static int keep_warning(TIFF*, void* self, const char*, const char* format, std::va_list values);

  const char* data_ = nullptr;  // of what is read
  std::size_t size_ = 0;
  std::string written_;
  bool is_writing_ = false;
  std::size_t position_ = 0;
  TIFF* tiff_ = nullptr;
  std::string complaint_;
  bool warnings_count_ = false;
  bool is_out_of_memory_ = false;
};

[[nodiscard]] inline bool is_ccitt(int compression) {
  return compression == COMPRESSION_CCITTRLE || compression == COMPRESSION_CCITTRLEW ||
         compression == COMPRESSION_CCITTFAX3 || compression == COMPRESSION_CCITTFAX4;
}

}  // namespace thinbench
