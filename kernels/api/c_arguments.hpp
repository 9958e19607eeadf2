// Arguments of the C interface to C++ types, results to handles, exceptions to statuses.
// Conversions throw std::invalid_argument.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/checks.hpp"
#include "thinbench.h"
#include "thinbench/distance.hpp"
#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"
#include "thinbench/packed.hpp"
#include "thinbench/regions.hpp"
#include "thinbench/rule.hpp"

namespace thinbench::detail {

/// Sets this thread's message and returns the status.
thinbench_status fail(thinbench_status status, const char* message) noexcept;

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

// Results.

/// Sets a handle to what `make` returns; NULL on failure.
template <class Handle, class Make>
thinbench_status give(Handle** handle, const char* name, const Make& make) noexcept {
  return guarded([&] {
    require_pointer(handle, name);
    *handle = nullptr;
    *handle = new Handle{make()};
  });
}

/// A member of a handle as an array of C structs: NULL, and a count of 0, for a NULL handle and
/// where the size of the caller's struct is another.
template <class Struct, class Handle, class Base, class T>
const Struct* list_of(const Handle* handle, std::vector<T> Base::*list, size_t* count,
                      size_t size) noexcept {
  static_assert(sizeof(Struct) == sizeof(T));
  const bool is_there = handle != nullptr && size == sizeof(Struct);
  if (count != nullptr) *count = is_there ? (handle->*list).size() : 0;
  return is_there ? reinterpret_cast<const Struct*>((handle->*list).data()) : nullptr;
}

/// Sets what a pointer that may be NULL points to.
template <class T, class Value>
void report(const Value& value, T* result) {
  if (result != nullptr) *result = value;
}

// Names.

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

template <class List>
const char* name_at(const List& list, size_t index) {
  return index < std::size(list) ? name_of(list[index]).data() : nullptr;
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

/// The same for an enumeration and its names.
template <class Value, class Names>
Value enumerator(const char* what, const char* name, const Names& names) {
  return static_cast<Value>(index_of(what, name, names));
}

[[nodiscard]] Isa isa_of(const char* name);

// Structs that begin with their size.

/// How large a struct was in version 1.0, which every caller has. A version that adds a member
/// specialises it with the place of this member.
template <class Struct>
inline constexpr size_t kFirstSize = sizeof(Struct);

/// Copies a struct of a caller to one that has the defaults of all members: the caller may know
/// fewer members, or more if these are 0.
void copy_known(void* known, size_t known_size, size_t first_size, const void* given,
                size_t given_size, const char* name);

/// The struct of a caller, whose reserved members must be 0.
template <class Struct>
Struct known(const Struct* given, const Struct& defaults, const char* name) {
  require_pointer(given, name);
  Struct result = defaults;
  if (given->size == sizeof(Struct)) {
    result = *given;
  } else {
    copy_known(&result, sizeof(Struct), kFirstSize<Struct>, given, given->size, name);
  }
  if constexpr (requires { result.reserved; }) {
    constexpr decltype(Struct::reserved) zeros{};
    require(std::memcmp(&result.reserved, &zeros, sizeof(zeros)) == 0,
            [&] { return name + std::string(".reserved: expected 0"); });
  }
  return result;
}

/// What a struct of results starts from.
template <class Struct>
Struct fresh(const Struct* given, const Struct& defaults, const char* name) {
  static_cast<void>(known(given, defaults, name));
  return defaults;
}

/// Sets what a caller knows of a struct of results.
template <class Struct>
void give_known(Struct value, Struct* given) {
  value.size = given->size;
  std::memcpy(given, &value, std::min(value.size, sizeof(Struct)));
}

// Options; NULL stands for the defaults.
[[nodiscard]] Thinning thinning_of(const thinbench_thinning* given);
[[nodiscard]] Execution execution_of(const thinbench_execution* given);
[[nodiscard]] Spacing spacing_of(const thinbench_spacing* given);

/// 8 or 4.
[[nodiscard]] Connectivity connectivity_of(std::int32_t number);

/// What a handle has.
[[nodiscard]] const Rule& rule_of(const thinbench_rule* handle);

// Images.
[[nodiscard]] ConstImageView image_of(const thinbench_image* image, const char* name = "source");
[[nodiscard]] LabelView labels_of(const thinbench_labels* labels, const char* name);
[[nodiscard]] View<double> reals_of(const thinbench_reals* reals, const char* name);

/// The image of a result, and what is written instead of 255.
template <class Image>
struct Written {
  Image view;
  std::uint8_t foreground;
};
[[nodiscard]] Written<ImageView> written(const thinbench_image* image,
                                         const char* name = "destination");
[[nodiscard]] Written<StackView> written(const thinbench_stack* stack, const char* name);

/// Replaces 255 by the value that the caller wants for foreground.
void set_foreground(const Written<ImageView>& image);
void set_foreground(const Written<StackView>& stack);

/// Calls `write` with the image of a result, of which the caller may want another foreground.
template <class Write>
void write_to(const thinbench_image* destination, const Write& write,
              const char* name = "destination") {
  const Written<ImageView> image = written(destination, name);
  write(image.view);
  set_foreground(image);
}

/// A list of the caller, which may be NULL without elements.
template <class T, class Struct>
std::span<const T> span_of(const Struct* list, size_t count, const char* name) {
  static_assert(sizeof(T) == sizeof(Struct));
  if (count > 0) require_pointer(list, name);
  return {reinterpret_cast<const T*>(list), count};
}

}  // namespace thinbench::detail
