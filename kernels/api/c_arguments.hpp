// Arguments of the C interface to C++ types, exceptions to statuses. Conversions throw
// std::invalid_argument.
#pragma once

#include <cstddef>
#include <cstring>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/checks.hpp"
#include "thinbench.h"
#include "thinbench/many.hpp"
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

// The name of an entry of a list, which may be the name itself.
[[nodiscard]] inline std::string_view name_of(std::string_view name) {
  return name;
}
[[nodiscard]] inline std::string_view name_of(Isa isa) {
  return isa_name(isa);
}
template <class Info>
std::string_view name_of(const Info& info) {
  return info.name;
}

template <class Infos>
const char* name_at(const Infos& infos, size_t index) {
  return index < infos.size() ? infos[index].name.data() : nullptr;
}

/// The value with this name, if there is one; the list has all names for the message.
template <class T, class List>
T named(const char* what, const char* name, std::optional<T> value, const List& list) {
  if (value) return *value;
  std::string names;
  for (const auto& entry : list) names.append(names.empty() ? "" : ", ").append(name_of(entry));
  throw std::invalid_argument(std::string(what) + ": expected one of " + names + "; got " +
                              text_of(name));
}

/// The place of this name in a list.
template <class List>
size_t index_of(const char* what, const char* name, const List& list) {
  std::optional<size_t> index;
  for (size_t i = 0; i < std::size(list); ++i) {
    if (name_of(list[i]) == view_of(name)) index = i;
  }
  return named(what, name, index, list);
}

[[nodiscard]] Isa isa_of(const char* name);

// Without padding at its end, a struct becomes larger by its next member.
static_assert(offsetof(thinbench_thinning, reserved) + sizeof(int32_t) ==
              sizeof(thinbench_thinning));
static_assert(offsetof(thinbench_execution, isa) + sizeof(void*) == sizeof(thinbench_execution));
static_assert(offsetof(thinbench_rule_info, reach) + sizeof(int32_t) ==
              sizeof(thinbench_rule_info));
static_assert(offsetof(thinbench_binarisation, reserved) + sizeof(int32_t) ==
              sizeof(thinbench_binarisation));
static_assert(offsetof(thinbench_pruning, spacing) + sizeof(void*) == sizeof(thinbench_pruning));

/// A struct whose caller may know fewer members than this library, but at least those up to `last`,
/// the last of version 1.0; the others keep their defaults.
template <class Struct, class Member>
Struct versioned(const Struct* given, Member Struct::*last, Struct defaults, const char* name,
                 const char* initialiser) {
  const auto* const begin = reinterpret_cast<const char*>(&defaults);
  const auto* const end = reinterpret_cast<const char*>(&(defaults.*last) + 1);
  const auto first_version = static_cast<size_t>(end - begin);
  require(first_version <= given->size && given->size <= sizeof(Struct), [&] {
    return std::string(name) + ".size: expected " + std::to_string(sizeof(Struct)) + ", got " +
           std::to_string(given->size) + "; " + initialiser + " sets it";
  });
  std::memcpy(&defaults, given, given->size);
  return defaults;
}

/// What fills a struct up, until a later version gives it a meaning.
inline void require_reserved(const char* name, int32_t reserved) {
  require(reserved == 0, [&] {
    return std::string(name) + ".reserved: expected 0, got " + std::to_string(reserved);
  });
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
  return spacing == nullptr ? Spacing{} : Spacing{spacing->x, spacing->y};
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
