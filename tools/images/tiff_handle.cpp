#include "images/tiff_handle.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <new>
#include <utility>

#include "support/text.hpp"

namespace thinbench {

TiffHandle::TiffHandle(std::string_view bytes) : data_(bytes.data()), size_(bytes.size()) {
  open("r");
}

TiffHandle::TiffHandle(const char* mode) : is_writing_(true), warnings_count_(true) {
  open(mode);
}

void TiffHandle::open(const char* mode) {
  constexpr tmsize_t codec_bytes = tmsize_t{1} << 28;  // for lists of a row, at most
  TIFFOpenOptions* const options = TIFFOpenOptionsAlloc();
  if (!is_writing_) {
    TIFFOpenOptionsSetMaxSingleMemAlloc(options, 2 * static_cast<tmsize_t>(size_) + codec_bytes);
  }
  TIFFOpenOptionsSetErrorHandlerExtR(options, keep_error, this);
  TIFFOpenOptionsSetWarningHandlerExtR(options, keep_warning, this);
  tiff_ = TIFFClientOpenExt("image", mode, this, read, write, seek, close, size_of, map, unmap,
                            options);
  TIFFOpenOptionsFree(options);
}

TiffHandle::~TiffHandle() {
  if (tiff_ != nullptr) TIFFClose(tiff_);
}

void TiffHandle::forget_complaints() {
  complaint_.clear();
  warnings_count_ = true;
}

std::string TiffHandle::take() {
  const bool is_whole = tiff_ != nullptr && TIFFFlush(tiff_) == 1 && complaint_.empty();
  if (!is_whole || is_out_of_memory_) throw std::bad_alloc();  // nothing else can fail
  TIFFClose(std::exchange(tiff_, nullptr));
  return std::move(written_);
}

tmsize_t TiffHandle::read(thandle_t self, void* to, tmsize_t count) {
  auto& file = *static_cast<TiffHandle*>(self);
  const std::string_view all =
      file.is_writing_ ? file.written_ : std::string_view(file.data_, file.size_);
  const std::size_t start = std::min(file.position_, all.size());
  const std::size_t got = std::min(static_cast<std::size_t>(count), all.size() - start);
  std::memcpy(to, all.data() + start, got);
  file.position_ = start + got;
  return static_cast<tmsize_t>(got);
}

tmsize_t TiffHandle::write(thandle_t self, void* from, tmsize_t count) {
  auto& file = *static_cast<TiffHandle*>(self);
  const std::size_t end = file.position_ + static_cast<std::size_t>(count);
  try {
    if (end > file.written_.size()) file.written_.resize(end);
  } catch (const std::bad_alloc&) {
    file.is_out_of_memory_ = true;
    return -1;
  }
  std::memcpy(file.written_.data() + file.position_, from, static_cast<std::size_t>(count));
  file.position_ = end;
  return count;
}

toff_t TiffHandle::seek(thandle_t self, toff_t offset, int whence) {
  auto& file = *static_cast<TiffHandle*>(self);
  const toff_t start = whence == SEEK_CUR ? file.position_ : whence == SEEK_END ? size_of(self) : 0;
  file.position_ = start + offset;
  return file.position_;
}

int TiffHandle::close(thandle_t /*self*/) {
  return 0;
}

toff_t TiffHandle::size_of(thandle_t self) {
  const auto& file = *static_cast<TiffHandle*>(self);
  return file.is_writing_ ? file.written_.size() : file.size_;
}

/// What is read lies in memory already.
int TiffHandle::map(thandle_t self, void** base, toff_t* size) {
  auto& file = *static_cast<TiffHandle*>(self);
  if (file.is_writing_) return 0;
  *base = const_cast<char*>(file.data_);
  *size = file.size_;
  return 1;
}

void TiffHandle::unmap(thandle_t /*self*/, void* /*base*/, toff_t /*size*/) {}

int TiffHandle::keep_error(TIFF* /*tiff*/, void* self, const char* /*function*/, const char* format,
                           std::va_list values) {
  std::array<char, 400> text{};
  static_cast<void>(std::vsnprintf(text.data(), text.size(), format, values));
  std::string& complaint = static_cast<TiffHandle*>(self)->complaint_;
  if (complaint.empty()) complaint = one_line(text.data());
  if (complaint.ends_with('.')) complaint.pop_back();
  return 1;  // libtiff prints nothing
}

int TiffHandle::keep_warning(TIFF* tiff, void* self, const char* function, const char* format,
                             std::va_list values) {
  const bool counts = static_cast<TiffHandle*>(self)->warnings_count_;
  return counts ? keep_error(tiff, self, function, format, values) : 1;
}

}  // namespace thinbench
