// libtiff's handle. Includes libtiff.
#pragma once

#include <array>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>

#include <tiffio.h>

#include "support/text.hpp"
#include "thinbench/image_view.hpp"

namespace thinbench {

inline Index file_size_or_0(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  return error ? 0 : static_cast<Index>(size);
}

inline bool is_ccitt(std::uint16_t compression) {
  return compression == COMPRESSION_CCITTRLE || compression == COMPRESSION_CCITTRLEW ||
         compression == COMPRESSION_CCITTFAX3 || compression == COMPRESSION_CCITTFAX4;
}

/// A file that libtiff has open, and the first thing that it complained of.
class OpenTiff {
 public:
  OpenTiff(const std::string& path, const char* mode) {
    TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
    TIFFOpenOptionsSetMaxSingleMemAlloc(options, 2 * file_size_or_0(path) + kCodecBytes);
    TIFFOpenOptionsSetErrorHandlerExtR(options, keep_complaint, this);
    TIFFOpenOptionsSetWarningHandlerExtR(options, keep_warning, this);
    tiff_ = TIFFOpenExt(path.c_str(), mode, options);
    TIFFOpenOptionsFree(options);
    warnings_count_ = true;
  }
  ~OpenTiff() {
    if (tiff_ != nullptr) TIFFClose(tiff_);
  }
  OpenTiff(const OpenTiff&) = delete;
  OpenTiff& operator=(const OpenTiff&) = delete;

  /// Null if the file could not be opened.
  [[nodiscard]] TIFF* get() const { return tiff_; }
  /// Empty if there is none. Warnings count only once the file is open: before, they tell of tags.
  [[nodiscard]] const std::string& complaint() const { return complaint_; }

  /// The value of a tag, else its default; kNone and 0 if it has none.
  static constexpr std::uint16_t kNone = 0xFFFF;
  [[nodiscard]] std::uint16_t small_number(std::uint32_t tag) const {
    std::uint16_t value = kNone;
    TIFFGetFieldDefaulted(tiff_, tag, &value);
    return value;
  }
  [[nodiscard]] Index number(std::uint32_t tag) const {
    std::uint32_t value = 0;
    TIFFGetFieldDefaulted(tiff_, tag, &value);
    return value;
  }
  [[nodiscard]] float real_number(std::uint32_t tag) const {
    float value = 0;
    return TIFFGetField(tiff_, tag, &value) == 1 ? value : 0;
  }

 private:
  static constexpr Index kCodecBytes = Index{1} << 28;  // for lists of a row, at most

  static int keep_complaint(TIFF* /*tiff*/, void* self, const char* /*function*/,
                            const char* format, std::va_list values) {
    std::array<char, 400> text{};
    static_cast<void>(std::vsnprintf(text.data(), text.size(), format, values));
    std::string& complaint = static_cast<OpenTiff*>(self)->complaint_;
    if (complaint.empty()) complaint = one_line(text.data());
    if (complaint.ends_with('.')) complaint.pop_back();
    return 1;  // libtiff prints nothing
  }
  static int keep_warning(TIFF* tiff, void* self, const char* function, const char* format,
                          std::va_list values) {
    const bool counts = static_cast<OpenTiff*>(self)->warnings_count_;
    return counts ? keep_complaint(tiff, self, function, format, values) : 1;
  }

  TIFF* tiff_ = nullptr;
  std::string complaint_;
  bool warnings_count_ = false;
};

}  // namespace thinbench
