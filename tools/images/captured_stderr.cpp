#include "images/captured_stderr.hpp"

#include <cstdio>
#include <iostream>
#include <streambuf>

#include <unistd.h>

namespace thinbench {
namespace {

constexpr std::size_t kMaxCaught = 65536;

thread_local std::string* caught = nullptr;  // by the innermost capture of this thread

void write_or_catch(const char* text, std::size_t size) {
  if (caught == nullptr) {
    static_cast<void>(!write(STDERR_FILENO, text, size));
  } else if (caught->size() < kMaxCaught) {
    caught->append(text, size);
  }
}

ssize_t write_cookie(void* /*cookie*/, const char* text, std::size_t size) {
  write_or_catch(text, size);
  return static_cast<ssize_t>(size);
}

class CatchingBuffer : public std::streambuf {
 protected:
  int_type overflow(int_type c) override {
    const char one = traits_type::to_char_type(c);
    if (!traits_type::eq_int_type(c, traits_type::eof())) write_or_catch(&one, 1);
    return traits_type::not_eof(c);
  }
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    write_or_catch(text, static_cast<std::size_t>(size));
    return size;
  }
};

/// Standard error is unbuffered before and after. Both objects live as long as the program, which
/// may write until its very end.
bool replace_standard_error() {
  cookie_io_functions_t functions{};
  functions.write = write_cookie;
  std::FILE* stream = fopencookie(nullptr, "w", functions);
  if (stream == nullptr) return false;
  std::setvbuf(stream, nullptr, _IONBF, 0);
  std::fflush(stderr);
  stderr = stream;  // the C library of GNU allows this
  std::cerr.rdbuf(new CatchingBuffer);
  return true;
}

}  // namespace

CapturedStderr::CapturedStderr() : outer_(caught) {
  [[maybe_unused]] static const bool replaced = replace_standard_error();
  caught = &text_;
}

CapturedStderr::~CapturedStderr() {
  caught = outer_;
}

}  // namespace thinbench
