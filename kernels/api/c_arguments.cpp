#include "api/c_arguments.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "rules/notation_reader.hpp"

namespace thinbench::detail {
namespace {

// Remains when the thread ends: its static and thread-local objects may call, too.
thread_local std::array<char, 1024> last_message{};

/// Where there is no next image, the distance to it says nothing and passes every check.
Index image_stride_of(Index given, Index count) {
  return count == 1 ? PTRDIFF_MAX : given;
}

void and_with(std::uint8_t* pixels, Index count, std::uint8_t value) {
  for (Index i = 0; i < count; ++i) pixels[i] &= value;
}

}  // namespace

thinbench_status fail(thinbench_status status, const char* message) noexcept {
  const std::size_t length = std::min(std::strlen(message), last_message.size() - 1);
  std::copy_n(message, length, last_message.begin());
  last_message[length] = 0;
  return status;
}

const char* last_error() {
  return last_message.data();
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

Thinning thinning_of(const thinbench_thinning* given) {
  Thinning thinning;
  if (given == nullptr) return thinning;
  const thinbench_thinning defaults = THINBENCH_THINNING_INIT;
  const auto from = versioned(given, &thinbench_thinning::reserved, defaults, "thinning",
                              "THINBENCH_THINNING_INIT");
  require_reserved("thinning", from.reserved);
  require(from.max_iterations >= 0, [&] {
    return "max_iterations: expected 1 or more, or 0 for the rule's own limit, got " +
           std::to_string(from.max_iterations);
  });
  if (from.max_iterations > 0) thinning.max_iterations = from.max_iterations;
  if (from.border != nullptr) {
    thinning.border = static_cast<Border>(index_of("border", from.border, kBorderNames));
  }
  return thinning;
}

Execution execution_of(const thinbench_execution* given) {
  Execution execution;
  if (given == nullptr) return execution;
  const thinbench_execution defaults = THINBENCH_EXECUTION_INIT;
  const auto from = versioned(given, &thinbench_execution::isa, defaults, "execution",
                              "THINBENCH_EXECUTION_INIT");
  execution.threads = from.threads;
  if (from.isa != nullptr) execution.isa = isa_of(from.isa);
  return execution;
}

ThinningCall call_of(const thinbench_rule* rule, const thinbench_thinning* thinning,
                     const thinbench_execution* execution) {
  return {rule_of(rule), thinning_of(thinning), execution_of(execution)};
}

ConstStackView source_of(const thinbench_stack* stack) {
  require_pointer(stack, "source");
  return {stack->data,   stack->count,  stack->width,
          stack->height, stack->stride, image_stride_of(stack->image_stride, stack->count)};
}

StackView destination_of(const thinbench_output* output, const ConstStackView& source) {
  require_pointer(output, "destination");
  return {output->data,  source.count,   source.width,
          source.height, output->stride, image_stride_of(output->image_stride, source.count)};
}

ConstImageView image_of(const thinbench_stack* stack) {
  const ConstStackView source = source_of(stack);
  require(source.count == 1,
          [&] { return "expected one image, got " + std::to_string(source.count); });
  return source.image(0);
}

PackedViews packed_views(const thinbench_packed* source, uint8_t* destination,
                         ptrdiff_t destination_stride) {
  require_pointer(source, "source");
  const BitOrder order = source->lsb_first != 0 ? BitOrder::lsb_first : BitOrder::msb_first;
  return {{source->data, source->width, source->height, source->stride, order},
          {destination, source->width, source->height, destination_stride, order}};
}

std::uint8_t foreground_of(const thinbench_output& output) {
  return output.foreground == 0 ? 255 : output.foreground;
}

void set_foreground(const thinbench_output* output, const StackView& written) {
  const std::uint8_t value = foreground_of(*output);
  if (value == 255) return;
  const Index pixels = written.width * written.height;
  if (pixels == 0) return;
  const bool contiguous =
      written.stride == written.width && (written.count == 1 || written.image_stride == pixels);
  if (contiguous) {
    and_with(written.data, written.count * pixels, value);
    return;
  }
  for (Index i = 0; i < written.count; ++i) {
    for (Index y = 0; y < written.height; ++y) {
      and_with(written.image(i).row(y), written.width, value);
    }
  }
}

}  // namespace thinbench::detail
