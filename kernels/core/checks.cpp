#include "core/checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <vector>

#include "thinbench/options.hpp"

namespace thinbench::detail {

void reject(const std::string& message) {
  throw std::invalid_argument(message);
}

namespace {

std::string text_of(const Memory& memory) {
  const std::string size = size_text(memory.width, memory.rows);
  return memory.images == 1 ? size : std::to_string(memory.images) + " images of " + size;
}

[[noreturn]] void reject_size(const Memory& memory) {
  if (memory.images == 1) reject(memory.name + (" has the size " + text_of(memory)));
  reject(memory.name + (" is " + text_of(memory)) + "; counts and sizes cannot be negative");
}

[[noreturn]] void reject_stride(const Memory& memory) {
  const std::string given = memory.name + (" has a stride of " + std::to_string(memory.stride)) +
                            (memory.element_bytes == 1 ? " bytes" : "");
  const std::string width = std::to_string(memory.width);
  if (memory.row_elements == memory.width) reject(given + ", below its width of " + width);
  reject(given + "; its rows of " + width + " pixels take " + std::to_string(memory.row_elements));
}

[[noreturn]] void reject_room(const Memory& memory) {
  reject(memory.name + (" exceeds the address space: " + text_of(memory)) +
         (memory.images == 1 ? ", stride " : ", strides ") + std::to_string(memory.stride) +
         (memory.images == 1 ? "" : " and " + std::to_string(memory.image_stride)));
}

/// Whether `count` strides are within `room`.
bool fits(Index stride, Index count, Index room) {
  return count == 0 || stride <= room / count;
}

/// Elements from the first to the last of an image.
Index image_elements(const Memory& memory) {
  if (memory.row_elements == 0 || memory.rows == 0) return 0;
  return (memory.rows - 1) * memory.stride + memory.row_elements;
}

/// Bytes from the first to the last of all images.
Index bytes_of(const Memory& memory) {
  const Index image = image_elements(memory);
  if (image == 0 || memory.images == 0) return 0;
  return ((memory.images - 1) * memory.image_stride + image) * memory.element_bytes;
}

/// Whether two images in one buffer are side by side: their strides are equal and their ranges of
/// columns are disjoint.
bool side_by_side(const Memory& a, const Memory& b) {
  const Index stride = a.stride * a.element_bytes;
  if (a.images != 1 || b.images != 1 || stride != b.stride * b.element_bytes) return false;
  const Index distance =
      static_cast<const std::uint8_t*>(b.data) - static_cast<const std::uint8_t*>(a.data);
  const Index column = (distance % stride + stride) % stride;
  return column >= a.row_elements * a.element_bytes &&
         column + b.row_elements * b.element_bytes <= stride;
}

/// Of images of one size: whether each pixel has one place. A stride to nothing does not matter.
bool same_memory(const Memory& a, const Memory& b) {
  return a.data == b.data && (a.rows == 1 || a.stride == b.stride) &&
         (a.images == 1 || a.image_stride == b.image_stride);
}

/// Bytes from `begin` to `end` that belong to image `image` of a list.
struct ListedBytes {
  std::uintptr_t begin;
  std::uintptr_t end;
  std::size_t image;
  bool is_destination;
};

/// Two ranges that share a byte.
struct Conflict {
  ListedBytes destination;
  ListedBytes other;
};

/// Finds a destination that shares a byte with another range. Sources may overlap.
std::optional<Conflict> find_conflict(std::vector<ListedBytes> all) {
  std::stable_sort(all.begin(), all.end(),
                   [](const ListedBytes& a, const ListedBytes& b) { return a.begin < b.begin; });
  ListedBytes last = {};  // of those before, the one that ends last
  ListedBytes last_destination = {};
  for (const ListedBytes& bytes : all) {
    if (bytes.is_destination && bytes.begin < last.end) return Conflict{bytes, last};
    if (bytes.begin < last_destination.end) return Conflict{last_destination, bytes};
    if (bytes.end > last.end) last = bytes;
    if (bytes.is_destination && bytes.end > last_destination.end) last_destination = bytes;
  }
  return std::nullopt;
}

/// The bytes of all images, or of each of their rows. An image thinned in place counts once.
std::vector<ListedBytes> bytes_of(std::span<const ConstImageView> sources,
                                  std::span<const ImageView> destinations, bool by_rows) {
  std::vector<ListedBytes> all;
  const auto add = [&](const Memory& memory, std::size_t image, bool is_destination) {
    const Index all_bytes = bytes_of(memory);
    const Index bytes = by_rows ? memory.width : all_bytes;
    const Index rows = by_rows ? memory.rows : 1;
    const auto* const data = static_cast<const std::uint8_t*>(memory.data);
    for (Index y = 0; y < rows && all_bytes > 0; ++y) {
      const auto begin = reinterpret_cast<std::uintptr_t>(data + y * memory.stride);
      all.push_back({begin, begin + static_cast<std::uintptr_t>(bytes), image, is_destination});
    }
  };
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const Memory source = memory_of("", sources[i]);
    const Memory destination = memory_of("", destinations[i]);
    if (!same_memory(source, destination)) add(source, i, false);
    add(destination, i, true);
  }
  return all;
}

}  // namespace

std::string number_text(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", number);
  return text.data();
}

std::string size_text(Index width, Index height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

void require_size(Index width, Index height) {
  if (width < 0 || height < 0) reject("image size " + size_text(width, height) + " is negative");
}

void require_max_pixels(Index width, Index height) {
  constexpr Index max_pixels = Index{1} << 40;
  if (width <= max_pixels && height <= max_pixels && (width == 0 || height <= max_pixels / width)) {
    return;
  }
  reject("image size " + size_text(width, height) + " is larger than 2^40 pixels");
}

void require_regions_size(Index width, Index height) {
  constexpr Index max_side = Index{1} << 29;
  require_size(width, height);
  if (width > max_side || height > max_side) {
    reject("image size " + size_text(width, height) + " has a side above 2^29 pixels");
  }
  if (width == 0 || height <= (Index{1} << 32) / width) return;
  reject("image size " + size_text(width, height) + " is larger than 2^32 pixels");
}

void require_label_size(Index width, Index height) {
  require_regions_size(width, height);
  if (width == 0 || height <= (Index{1} << 31) / width) return;
  reject("image size " + size_text(width, height) +
         " is larger than 2^31 pixels, the limit for labels");
}

void require_not_negative(const char* name, double number) {
  require(number >= 0 && std::isfinite(number), [&] {
    return std::string(name) + ": expected a finite number of at least 0, got " +
           number_text(number);
  });
}

void require_spacing(const Spacing& spacing) {
  for (const double distance : {spacing.x, spacing.y}) {
    require(distance >= 1e-30 && distance <= 1e30, [&] {
      return "spacing: expected numbers from 1e-30 to 1e30, got " + number_text(distance);
    });
  }
}

void require_connectivity(int connectivity) {
  if (connectivity == 4 || connectivity == 8) return;
  reject("connectivity: expected 4 or 8, got " + std::to_string(connectivity));
}

void require_threads(int threads) {
  if (threads >= 1 && threads <= kMaxThreads) return;
  reject("threads: expected an integer in [1, " + std::to_string(kMaxThreads) + "], got " +
         std::to_string(threads));
}

void check(const Memory& memory) {
  if (memory.width < 0 || memory.rows < 0 || memory.images < 0) reject_size(memory);
  if (memory.stride < memory.row_elements) reject_stride(memory);
  const Index room = PTRDIFF_MAX / memory.element_bytes;
  if (!fits(memory.stride, std::max<Index>(memory.rows, 1), room)) reject_room(memory);
  if (memory.images != 1) {
    if (memory.image_stride < image_elements(memory)) {
      reject(memory.name + (" has an image stride of " + std::to_string(memory.image_stride)) +
             " bytes; its images take " + std::to_string(image_elements(memory)));
    }
    if (!fits(memory.image_stride, memory.images, room)) reject_room(memory);
  }
  if (memory.data == nullptr && bytes_of(memory) > 0)
    reject(memory.name + std::string(" has no data"));
}

bool overlap(const Memory& a, const Memory& b) {
  const Index a_bytes = bytes_of(a);
  const Index b_bytes = bytes_of(b);
  if (a_bytes == 0 || b_bytes == 0) return false;
  const auto a_begin = reinterpret_cast<std::uintptr_t>(a.data);
  const auto b_begin = reinterpret_cast<std::uintptr_t>(b.data);
  return a_begin < b_begin + static_cast<std::uintptr_t>(b_bytes) &&
         b_begin < a_begin + static_cast<std::uintptr_t>(a_bytes) && !side_by_side(a, b);
}

void check(const Memory& source, const Memory& destination, InPlace in_place) {
  check(source);
  check(destination);
  const bool is_stack = source.images != 1 || destination.images != 1;
  if (source.width != destination.width || source.rows != destination.rows ||
      source.images != destination.images) {
    reject(source.name + (" is " + text_of(source)) + " and " + destination.name + " " +
           text_of(destination) + "; they must have the same " +
           (is_stack ? "count and size" : "size"));
  }
  const bool allowed = in_place == InPlace::allowed;
  if (!overlap(source, destination) || (allowed && same_memory(source, destination))) return;
  reject(source.name + std::string(" and ") + destination.name + " overlap" +
         (allowed ? " without being the same image" : "") + (allowed && is_stack ? "s" : ""));
}

void check_lists(std::span<const ConstImageView> sources, std::span<const ImageView> destinations) {
  require(sources.size() == destinations.size(),
          "expected as many destinations as sources, got " + std::to_string(sources.size()) +
              " sources and " + std::to_string(destinations.size()) + " destinations");
  for (std::size_t i = 0; i < sources.size(); ++i) {
    try {
      check_views(sources[i], destinations[i], InPlace::allowed);
      require_max_pixels(sources[i].width, sources[i].height);
    } catch (const std::invalid_argument& error) {
      reject("image " + std::to_string(i) + ": " + error.what());
    }
  }
  if (!find_conflict(bytes_of(sources, destinations, false))) return;
  const auto found = find_conflict(bytes_of(sources, destinations, true));
  if (!found) return;  // images side by side
  reject("the destination of image " + std::to_string(found->destination.image) +
         " shares bytes with the " + (found->other.is_destination ? "destination" : "source") +
         " of image " + std::to_string(found->other.image));
}

}  // namespace thinbench::detail
