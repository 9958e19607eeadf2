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
#include <vector>

#include "core/checks.hpp"
#include "thinbench.h"
#include "thinbench/batch.hpp"
#include "thinbench/packed.hpp"
#include "thinbench/thinning.hpp"
#include "thinning/operations.hpp"

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
Struct versioned(const Struct* given, size_t first_version, Struct defaults, const char* name,
                 const char* initialiser) {
  require(first_version <= given->size && given->size <= sizeof(Struct), [&] {
    return std::string(name) + ".size: expected " + std::to_string(sizeof(Struct)) + ", got " +
           std::to_string(given->size) + "; " + initialiser + " sets it";
  });
  std::memcpy(&defaults, given, given->size);
  return defaults;
}

/// NULL: as the rule says.
[[nodiscard]] Thinning thinning_of(const thinbench_thinning* given);

/// NULL: the defaults.
[[nodiscard]] Execution execution_of(const thinbench_execution* given);

/// What a handle has.
[[nodiscard]] const Rule& rule_of(const thinbench_rule* handle);

[[nodiscard]] ThinningCall call_of(const thinbench_rule* rule, const thinbench_thinning* thinning,
                                   const thinbench_execution* execution);

[[nodiscard]] ConstStackView source_of(const thinbench_stack* stack);
[[nodiscard]] StackView destination_of(const thinbench_output* output,
                                       const ConstStackView& source);
/// The image of a stack of one.
[[nodiscard]] ConstImageView image_of(const thinbench_stack* stack);

[[nodiscard]] inline Spacing spacing_of(const thinbench_spacing* spacing) {
  return spacing == nullptr ? Spacing{} : Spacing{spacing->y, spacing->x};
}

/// A member of a handle as an array of C structs: NULL, and a count of 0, for a NULL handle and
/// where the size of the caller's struct is another.
template <class Struct, class Handle, class Base, class T>
const Struct* list_of(const Handle* handle, std::vector<T> Base::*list, size_t* count,
                      size_t size) {
  const bool is_there = handle != nullptr && size == sizeof(Struct);
  if (count != nullptr) *count = is_there ? (handle->*list).size() : 0;
  return is_there ? reinterpret_cast<const Struct*>((handle->*list).data()) : nullptr;
}

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

}  // namespace thinbench::detail
