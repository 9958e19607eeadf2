#include "image/check_stacks.hpp"

#include <cstdint>
#include <stdexcept>
#include <string>

#include "image/checks.hpp"

namespace thinbench::detail {
namespace {

std::string text_of(const ConstStackView& stack) {
  return std::to_string(stack.count) + " images of " + size_text(stack.width, stack.height);
}

/// Bytes from the first pixel of an image to its last, where there are any.
Index image_bytes(const ConstStackView& stack) {
  if (stack.width == 0 || stack.height == 0) return 0;
  return (stack.height - 1) * stack.stride + stack.width;
}

bool has_pixels(const ConstStackView& stack) {
  return stack.count > 0 && image_bytes(stack) > 0;
}

// Texts are made where they are thrown: stacks are checked in every run, which allocates nothing.

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument(why);
}

[[noreturn]] void refuse_as_too_large(const ConstStackView& stack, const char* name) {
  refuse(name + (" spans more memory than there is: " + text_of(stack)) + ", strides " +
         std::to_string(stack.stride) + " and " + std::to_string(stack.image_stride));
}

void check_strides(const ConstStackView& stack, const char* name) {
  if (stack.stride < stack.width) {
    refuse(name + (" has a stride of " + std::to_string(stack.stride)) +
           " bytes, below its width of " + std::to_string(stack.width));
  }
  if (stack.height > 0 && stack.stride > PTRDIFF_MAX / stack.height) {
    refuse_as_too_large(stack, name);
  }
  if (stack.image_stride < image_bytes(stack)) {
    refuse(name + (" has an image stride of " + std::to_string(stack.image_stride)) +
           " bytes; its images take " + std::to_string(image_bytes(stack)));
  }
  if (stack.count > 0 && stack.image_stride > PTRDIFF_MAX / stack.count) {
    refuse_as_too_large(stack, name);
  }
}

void check_stack(const ConstStackView& stack, const char* name) {
  if (stack.count < 0 || stack.width < 0 || stack.height < 0) {
    refuse(name + (" is " + text_of(stack)) + "; counts and sizes cannot be negative");
  }
  check_strides(stack, name);
  if (stack.data == nullptr && has_pixels(stack)) refuse(name + std::string(" has no data"));
}

bool same_stack(const ConstStackView& a, const ConstStackView& b) {
  return a.data == b.data && a.stride == b.stride && a.image_stride == b.image_stride;
}

bool overlap(const ConstStackView& a, const ConstStackView& b) {
  if (!has_pixels(a)) return false;
  const auto begin = [](const ConstStackView& s) {
    return reinterpret_cast<std::uintptr_t>(s.data);
  };
  const auto end = [&](const ConstStackView& s) {
    return begin(s) + static_cast<std::uintptr_t>((s.count - 1) * s.image_stride + image_bytes(s));
  };
  return begin(a) < end(b) && begin(b) < end(a);
}

}  // namespace

void check_stacks(const ConstStackView& source, const ConstStackView& destination) {
  check_stack(source, "source");
  check_stack(destination, "destination");
  if (source.count != destination.count || source.width != destination.width ||
      source.height != destination.height) {
    refuse("source is " + text_of(source) + " and destination " + text_of(destination) +
           "; they must be alike");
  }
  if (overlap(source, destination) && !same_stack(source, destination)) {
    refuse("source and destination overlap without being the same images");
  }
}

}  // namespace thinbench::detail
