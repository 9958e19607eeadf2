// Checks of arguments at the public interface, before anything is allocated or written. All throw
// std::invalid_argument.
#pragma once

#include <concepts>
#include <span>
#include <string>

#include "thinbench/distance.hpp"
#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"
#include "thinbench/packed.hpp"

namespace thinbench::detail {

[[noreturn]] void reject(const std::string& message);
/// Throws with this message unless the condition holds.
inline void require(bool condition, const std::string& message) {
  if (!condition) reject(message);
}
inline void require(bool condition, const char* message) {
  if (!condition) reject(message);
}
/// The same with a message that is made only if it is needed: for what every call or pixel checks.
template <std::invocable Text>
void require(bool condition, const Text& text) {
  if (!condition) reject(text());
}

/// "510 x 412", for messages.
[[nodiscard]] std::string size_text(Index width, Index height);
/// "0.25", for messages.
[[nodiscard]] std::string number_text(double number);

// Each rejects what it names: a negative size, more than 2^40 pixels, threads outside [1,
// kMaxThreads].
void require_size(Index width, Index height);
void require_max_pixels(Index width, Index height);
void require_threads(int threads);
/// 4 or 8.
void require_connectivity(int connectivity);
void require_not_negative(const char* name, double number);
/// Both within [1e-30, 1e30], so that no square of a length overflows.
void require_spacing(const Spacing& spacing);

// Limits of labels and keys, which are 32-bit numbers: a side of 2^29, 2^32 pixels with regions and
// 2^31 with labels.
void require_regions_size(Index width, Index height);
void require_label_size(Index width, Index height);

/// The memory of an image, a packed image or a stack of images, whatever its elements are.
struct Memory {
  const char* name;  // for messages
  const void* data;
  Index element_bytes;
  Index width;  // in pixels
  Index rows;
  Index row_elements;  // that have pixels
  Index stride;        // in elements, as image_stride
  Index images = 1;
  Index image_stride = 0;
};

template <class T>
[[nodiscard]] Memory memory_of(const char* name, const View<T>& view) {
  return {name, view.data, sizeof(T), view.width, view.height, view.width, view.stride};
}

template <class T>
[[nodiscard]] Memory memory_of(const char* name, const Packed<T>& view) {
  const Index row_bytes = packed_row_bytes(view.width);
  return {name, view.data, 1, view.width, view.height, row_bytes, view.stride};
}

template <class T>
[[nodiscard]] Memory memory_of(const char* name, const Stack<T>& stack) {
  return {name,        stack.data,   sizeof(T),   stack.width,       stack.height,
          stack.width, stack.stride, stack.count, stack.image_stride};
}

enum class InPlace : bool { rejected, allowed };

/// Rejects a negative count or size, a row or an image that does not fit its stride, what exceeds
/// the address space, and pixels without data.
void check(const Memory& memory);

/// The same for both, and rejects counts or sizes that differ, and bytes that both have.
/// `in_place`: whether both may be the same memory. Images side by side in one buffer share no
/// byte; stacks with interleaved images count as overlapping. Allocates nothing unless it throws.
void check(const Memory& source, const Memory& destination, InPlace in_place);

/// Whether they share a byte, see above. Both must have passed check().
[[nodiscard]] bool overlap(const Memory& a, const Memory& b);

/// The same for two views of any kind, called source and destination.
template <class Source, class Destination>
void check_views(const Source& source, const Destination& destination, InPlace in_place) {
  check(memory_of("source", source), memory_of("destination", destination), in_place);
}

/// The same for lists of images of any sizes, and rejects more than 2^40 pixels and lists of
/// different lengths. Each destination is its source or shares no byte with any image of the lists.
void check_lists(std::span<const ConstImageView> sources, std::span<const ImageView> destinations);

}  // namespace thinbench::detail
