#include "api/c_arguments.hpp"

#include <algorithm>
#include <array>

#include "rules/notation_reader.hpp"
#include "thinbench/version.hpp"

namespace thinbench::detail {
namespace {

// Remains when the thread ends: its static and thread-local objects may call, too.
thread_local std::array<char, 1024> last_message{};

/// A larger struct is a size that was never set.
constexpr size_t kMaxStructSize = 1024;

void require_struct_size(size_t size, size_t first_size, const char* name) {
  require(first_size <= size && size <= kMaxStructSize, [&] {
    return name + (".size: expected an integer in [" + std::to_string(first_size)) + ", " +
           std::to_string(kMaxStructSize) + "], got " + std::to_string(size) +
           "; the struct's THINBENCH_..._INIT sets it";
  });
}

/// What a newer caller sets, and this library does not know.
void require_zeros(const unsigned char* bytes, size_t begin, size_t end, const char* name) {
  for (size_t i = begin; i < end; ++i) {
    require(bytes[i] == 0, [&] {
      return name + (": byte " + std::to_string(i)) + " is not 0, part of a member that version " +
             std::string(kVersion) + " of the library does not have";
    });
  }
}

void and_with(std::uint8_t* pixels, Index count, std::uint8_t value) {
  for (Index i = 0; i < count; ++i) pixels[i] &= value;
}

std::uint8_t foreground_of(std::uint8_t given) {
  return given == 0 ? 255 : given;
}

}  // namespace

thinbench_status fail(thinbench_status status, const char* message) noexcept {
  const std::size_t length = std::min(std::strlen(message), last_message.size() - 1);
  std::copy_n(message, length, last_message.begin());
  last_message[length] = 0;
  return status;
}

void require_pointer(const void* pointer, const char* name) {
  require(pointer != nullptr, [&] { return name + std::string(" is NULL"); });
}

std::string_view view_of(const char* name) {
  return name == nullptr ? std::string_view() : name;
}

std::string text_of(const char* name) {
  return name == nullptr ? "NULL" : quoted(name);
}

Isa isa_of(const char* name) {
  return named("isa", name, isa_from_name(view_of(name)), all_isas());
}

void copy_known(void* known, size_t known_size, size_t first_size, const void* given,
                size_t given_size, const char* name) {
  require_struct_size(given_size, first_size, name);
  require_zeros(static_cast<const unsigned char*>(given), known_size, given_size, name);
  std::memcpy(known, given, std::min(known_size, given_size));
}

Thinning thinning_of(const thinbench_thinning* given) {
  Thinning thinning;
  if (given == nullptr) return thinning;
  const auto from = known(given, thinbench_thinning THINBENCH_THINNING_INIT, "thinning");
  require(from.max_iterations >= 0, [&] {
    return "max_iterations: expected 1 or more, or 0 for the rule's own limit, got " +
           std::to_string(from.max_iterations);
  });
  if (from.max_iterations > 0) thinning.max_iterations = from.max_iterations;
  if (from.border != nullptr) {
    thinning.border = enumerator<Border>("border", from.border, kBorderNames);
  }
  return thinning;
}

Execution execution_of(const thinbench_execution* given) {
  Execution execution;
  if (given == nullptr) return execution;
  const auto from = known(given, thinbench_execution THINBENCH_EXECUTION_INIT, "execution");
  execution.threads = from.threads;
  if (from.isa != nullptr) execution.isa = isa_of(from.isa);
  return execution;
}

Spacing spacing_of(const thinbench_spacing* given) {
  if (given == nullptr) return {};
  const auto from = known(given, thinbench_spacing THINBENCH_SPACING_INIT, "spacing");
  return {from.x, from.y};
}

Connectivity connectivity_of(std::int32_t number) {
  require_connectivity(number);
  return static_cast<Connectivity>(number);
}

ConstImageView image_of(const thinbench_image* image, const char* name) {
  return written(image, name).view;
}

LabelView labels_of(const thinbench_labels* labels, const char* name) {
  const auto from = known(labels, thinbench_labels THINBENCH_LABELS_INIT, name);
  return {from.data, from.width, from.height, from.stride};
}

View<double> reals_of(const thinbench_reals* reals, const char* name) {
  const auto from = known(reals, thinbench_reals THINBENCH_REALS_INIT, name);
  return {from.data, from.width, from.height, from.stride};
}

Written<ImageView> written(const thinbench_image* image, const char* name) {
  const auto to = known(image, thinbench_image THINBENCH_IMAGE_INIT, name);
  return {{to.data, to.width, to.height, to.stride}, foreground_of(to.foreground)};
}

Written<StackView> written(const thinbench_stack* stack, const char* name) {
  const auto to = known(stack, thinbench_stack THINBENCH_STACK_INIT, name);
  return {{to.data, to.count, to.width, to.height, to.stride, to.image_stride},
          foreground_of(to.foreground)};
}

void set_foreground(const Written<ImageView>& image) {
  const auto& [view, value] = image;
  if (value == 255 || view.width == 0 || view.height == 0) return;
  if (view.stride == view.width) {
    and_with(view.data, view.width * view.height, value);
    return;
  }
  for (Index y = 0; y < view.height; ++y) and_with(view.row(y), view.width, value);
}

void set_foreground(const Written<StackView>& stack) {
  if (stack.foreground == 255) return;
  for (Index i = 0; i < stack.view.count; ++i) {
    set_foreground(Written<ImageView>{stack.view.image(i), stack.foreground});
  }
}

}  // namespace thinbench::detail

const char* thinbench_last_error() {
  return thinbench::detail::last_message.data();
}
