// Arguments of the C interface to C++ types, exceptions to statuses. Conversions throw
// std::invalid_argument.
#pragma once

#include <algorithm>
#include <cstring>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "image/checks.hpp"
#include "thinbench.h"
#include "thinbench/batch.hpp"
#include "thinbench/packed.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench::detail {

/// Sets this thread's message and returns the status.
thinbench_status fail(thinbench_status status, const char* message) noexcept;

/// The message of this thread's last failure.
[[nodiscard]] const char* last_error();

/// Runs a body and turns its exceptions into a status.
template <class Body>
thinbench_status guarded(const Body& body) noexcept {
  try {
    body();
    return THINBENCH_OK;
  } catch (const std::bad_alloc&) {
    return fail(THINBENCH_OUT_OF_MEMORY, "out of memory");
  } catch (const std::invalid_argument& error) {
    return fail(THINBENCH_INVALID_ARGUMENT, error.what());
  } catch (const std::exception& error) {
    return fail(THINBENCH_INTERNAL_ERROR, error.what());
  } catch (...) {
    return fail(THINBENCH_INTERNAL_ERROR, "unknown error");
  }
}

void require_pointer(const void* pointer, const char* name);

[[nodiscard]] std::string_view view_of(const char* name);

/// "NULL" or the name in quotation marks, for messages of one line.
[[nodiscard]] std::string text_of(const char* name);

template <class Infos>
std::string names_of(const Infos& infos) {
  std::string names;
  for (const auto& info : infos) names.append(names.empty() ? "" : ", ").append(info.name);
  return names;
}

template <class Infos>
const char* name_at(const Infos& infos, size_t index) {
  return index < infos.size() ? infos[index].name.data() : nullptr;
}

/// The value with this name, if there is one; `names` lists all for the message.
template <class T, class Names>
T named(const char* what, const char* name, std::optional<T> value, const Names& names) {
  if (!value) {
    throw std::invalid_argument(std::string(what) + ": expected one of " + names() + "; got " +
                                text_of(name));
  }
  return *value;
}

[[nodiscard]] Isa isa_of(const char* name);

/// A struct whose caller may know fewer members than this library, but at least those up to
/// `first_version`; the others keep their defaults.
template <class Struct>
Struct versioned(const Struct* given, size_t first_version, Struct defaults, const char* name) {
  require(first_version <= given->size && given->size <= sizeof(Struct),
          std::string(name) + ".size: expected " + std::to_string(sizeof(Struct)) + ", got " +
              std::to_string(given->size));
  std::memcpy(&defaults, given, given->size);
  return defaults;
}

/// NULL: the defaults.
[[nodiscard]] Options options_of(const thinbench_options* given);

[[nodiscard]] ConstStackView source_of(const thinbench_stack* stack);
[[nodiscard]] StackView destination_of(const thinbench_output* output,
                                       const ConstStackView& source);
/// The image of a stack of one.
[[nodiscard]] ConstImageView image_of(const thinbench_stack* stack);

struct PackedViews {
  ConstPackedView source;
  PackedView destination;
};
[[nodiscard]] PackedViews packed_views(const thinbench_packed* source, uint8_t* destination,
                                       ptrdiff_t destination_stride);

/// The value that the caller wants for foreground.
[[nodiscard]] std::uint8_t foreground_of(const thinbench_output& output);

/// Replaces 255 by the value that the caller wants for foreground.
void set_foreground(const thinbench_output* output, const StackView& written);

/// A number of threads for which each has enough images.
[[nodiscard]] int useful_threads(Index images, int threads);

/// Images [first, last) of a stack.
template <class Stack>
Stack part_of(Stack stack, Index first, Index last) {
  stack.data += first * stack.image_stride;
  stack.count = last - first;
  return stack;
}

/// Applies a rule to a stack in parts that stay in the cache until their foreground has its value.
template <class AnyRule>
int run_stack(const AnyRule& rule, const ConstStackView& source, const StackView& destination,
              const Options& options, const thinbench_output* output) {
  constexpr Index part_bytes = Index{1} << 18;
  check_stacks(source, destination);
  require_threads(options.threads);
  Options useful = options;
  useful.threads = useful_threads(source.count, options.threads);
  ThinningBatch batch(rule, source.width, source.height, useful);
  const Index image_bytes = std::max<Index>(1, source.height * source.stride);
  const Index part = std::max<Index>(16, part_bytes / image_bytes * options.threads);
  int iterations = 0;
  for (Index first = 0; first < source.count; first += part) {
    const Index last = std::min(first + part, source.count);
    const StackView written = part_of(destination, first, last);
    iterations = std::max(iterations, batch(part_of(source, first, last), written));
    set_foreground(output, written);
  }
  return iterations;
}

/// Applies a rule to an image or a stack and sets `iterations` if it is not NULL.
template <class AnyRule>
void run_images(const AnyRule& rule, const thinbench_stack* source,
                const thinbench_output* destination, const thinbench_options* options,
                int32_t* iterations) {
  const ConstStackView from = source_of(source);
  const StackView to = destination_of(destination, from);
  const Options given = options_of(options);
  int count = 0;
  if (from.count == 1) {
    check_views(from.image(0), to.image(0), InPlace::allowed);
    count = Thinner(rule, from.width, from.height, given)(from.image(0), to.image(0));
    set_foreground(destination, to);
  } else {
    count = run_stack(rule, from, to, given, destination);
  }
  if (iterations != nullptr) *iterations = count;
}

}  // namespace thinbench::detail
