#include "core/checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "thinbench/options.hpp"

namespace thinbench::detail {
namespace {

[[noreturn]] void reject(const std::string& reason) {
  throw std::invalid_argument(reason);
}

template <class View>
std::string text_of(const View& view) {
  return size_text(view.width, view.height);
}

std::string text_of(const ConstStackView& stack) {
  return std::to_string(stack.count) + " images of " + size_text(stack.width, stack.height);
}

/// Rejects a stride below the width.
template <class View>
void check_stride(const View& view, const char* name) {
  if (view.stride >= view.width) return;
  reject(name + (" has a stride of " + std::to_string(view.stride)) +
         " bytes, below its width of " + std::to_string(view.width));
}

/// Whether `count` strides exceed the address space.
bool overflows(Index stride, Index count) {
  return count > 0 && stride > PTRDIFF_MAX / count;
}

void check_view(const ConstImageView& view, const char* name) {
  if (view.width < 0 || view.height < 0) reject(name + (" has the size " + text_of(view)));
  check_stride(view, name);
  if (overflows(view.stride, view.height)) {
    reject(name + (" exceeds the address space: " + text_of(view)) + ", stride " +
           std::to_string(view.stride));
  }
  if (view.data == nullptr && view.width > 0 && view.height > 0) {
    reject(name + std::string(" has no data"));
  }
}

template <class View>
void check_same_size(const View& source, const View& destination) {
  if (source.width == destination.width && source.height == destination.height) return;
  reject("source is " + text_of(source) + " and destination " + text_of(destination) +
         "; they must have the same size");
}

/// Checks a packed image and returns its bytes as an image.
ConstImageView check_packed(const ConstPackedView& view, const char* name) {
  if (view.width < 0 || view.height < 0) reject(name + (" has the size " + text_of(view)));
  const Index row_bytes = packed_row_bytes(view.width);
  if (view.stride < row_bytes) {
    reject(name + (" has a stride of " + std::to_string(view.stride)) + " bytes; its rows of " +
           std::to_string(view.width) + " pixels take " + std::to_string(row_bytes));
  }
  if (view.order != BitOrder::msb_first && view.order != BitOrder::lsb_first) {
    reject(name + (" has the bit order " + std::to_string(static_cast<int>(view.order))) +
           "; expected msb_first or lsb_first");
  }
  const ConstImageView bytes(view.data, row_bytes, view.height, view.stride);
  check_view(bytes, name);
  return bytes;
}

bool same_image(const ConstImageView& a, const ConstImageView& b) {
  return a.data == b.data && a.stride == b.stride;
}

/// Whether two views of one buffer are side by side: their strides are equal and their ranges of
/// columns are disjoint.
bool side_by_side(const ConstImageView& a, const ConstImageView& b) {
  if (a.stride != b.stride) return false;
  const Index distance = b.data - a.data;
  const Index column = (distance % a.stride + a.stride) % a.stride;
  return column >= a.width && column + b.width <= a.stride;
}

/// Whether [a, a + a_bytes) and [b, b + b_bytes) share a byte.
bool ranges_overlap(const std::uint8_t* a, Index a_bytes, const std::uint8_t* b, Index b_bytes) {
  const auto a_begin = reinterpret_cast<std::uintptr_t>(a);
  const auto b_begin = reinterpret_cast<std::uintptr_t>(b);
  return a_begin < b_begin + static_cast<std::uintptr_t>(b_bytes) &&
         b_begin < a_begin + static_cast<std::uintptr_t>(a_bytes);
}

/// Bytes from the first to the last pixel of an image; 0 without pixels.
template <class View>
Index image_bytes(const View& view) {
  if (view.width == 0 || view.height == 0) return 0;
  return (view.height - 1) * view.stride + view.width;
}

/// A view of the bytes of numbers. `exceed` begins the message if it leaves the address space.
template <class T>
ConstImageView bytes_of(const View<T>& numbers, const char* exceed) {
  constexpr Index bytes = sizeof(T);
  constexpr Index most = PTRDIFF_MAX / bytes;
  if (std::max(numbers.stride, numbers.width) > most ||
      std::min(numbers.stride, numbers.width) < -most) {
    reject(exceed + (" the address space: " + text_of(numbers)) + ", stride " +
           std::to_string(numbers.stride));
  }
  return {reinterpret_cast<const std::uint8_t*>(numbers.data), numbers.width * bytes,
          numbers.height, numbers.stride * bytes};
}

bool overlap(const ConstImageView& a, const ConstImageView& b) {
  if (image_bytes(a) == 0) return false;
  return ranges_overlap(a.data, image_bytes(a), b.data, image_bytes(b)) && !side_by_side(a, b);
}

/// Checks two images of numbers, which must have the same size and share no byte.
template <class S, class T>
void check_pair(const View<S>& source, const std::string& source_name, const View<T>& numbers,
                const std::string& name) {
  const ConstImageView from = bytes_of(source, (source_name + " exceeds").c_str());
  const ConstImageView to = bytes_of(numbers, (name + " exceed").c_str());
  check_disjoint(from, source_name, to, name);
  if (source.width != numbers.width || source.height != numbers.height) {
    reject(source_name + " is " + text_of(source) + " and " + name + " " + text_of(numbers) +
           "; they must have the same size");
  }
}

bool has_pixels(const ConstStackView& stack) {
  return stack.count > 0 && image_bytes(stack) > 0;
}

void check_stack(const ConstStackView& stack, const char* name) {
  if (stack.count < 0 || stack.width < 0 || stack.height < 0) {
    reject(name + (" is " + text_of(stack)) + "; counts and sizes cannot be negative");
  }
  check_stride(stack, name);
  const bool images_fit = !overflows(stack.stride, stack.height);
  if (images_fit && stack.image_stride < image_bytes(stack)) {
    reject(name + (" has an image stride of " + std::to_string(stack.image_stride)) +
           " bytes; its images take " + std::to_string(image_bytes(stack)));
  }
  if (!images_fit || overflows(stack.image_stride, stack.count)) {
    reject(name + (" exceeds the address space: " + text_of(stack)) + ", strides " +
           std::to_string(stack.stride) + " and " + std::to_string(stack.image_stride));
  }
  if (stack.data == nullptr && has_pixels(stack)) reject(name + std::string(" has no data"));
}

bool same_stack(const ConstStackView& a, const ConstStackView& b) {
  return a.data == b.data && a.stride == b.stride && a.image_stride == b.image_stride;
}

bool overlap(const ConstStackView& a, const ConstStackView& b) {
  const auto bytes = [](const ConstStackView& stack) {
    return (stack.count - 1) * stack.image_stride + image_bytes(stack);
  };
  return has_pixels(a) && ranges_overlap(a.data, bytes(a), b.data, bytes(b));
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
  const auto add = [&](const ConstImageView& view, std::size_t image, bool is_destination) {
    const Index bytes = by_rows ? view.width : image_bytes(view);
    const Index rows = by_rows ? view.height : 1;
    for (Index y = 0; y < rows && image_bytes(view) > 0; ++y) {
      const auto begin = reinterpret_cast<std::uintptr_t>(view.row(y));
      all.push_back({begin, begin + static_cast<std::uintptr_t>(bytes), image, is_destination});
    }
  };
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (!same_image(sources[i], destinations[i])) add(sources[i], i, false);
  }
  for (std::size_t i = 0; i < sources.size(); ++i) add(destinations[i], i, true);
  return all;
}

}  // namespace

void require(bool condition, const std::string& message) {
  if (!condition) reject(message);
}

void require(bool condition, const char* message) {
  if (!condition) reject(message);
}

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
  for (const double distance : {spacing.y, spacing.x}) {
    require(distance >= 1e-30 && distance <= 1e30, [&] {
      return "spacing: expected numbers from 1e-30 to 1e30, got " + number_text(spacing.y) + ", " +
             number_text(spacing.x);
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

void check_disjoint(const ConstImageView& a, const std::string& a_name, const ConstImageView& b,
                    const std::string& b_name) {
  check_view(a, a_name.c_str());
  check_view(b, b_name.c_str());
  if (image_bytes(a) > 0 && ranges_overlap(a.data, image_bytes(a), b.data, image_bytes(b))) {
    reject(a_name + " and " + b_name + " overlap");
  }
}

void check_views(const ConstImageView& source, const ConstImageView& destination,
                 InPlace in_place) {
  check_view(source, "source");
  check_view(destination, "destination");
  check_same_size(source, destination);
  if (!overlap(source, destination)) return;
  if (in_place == InPlace::rejected) reject("source and destination overlap");
  if (!same_image(source, destination)) {
    reject("source and destination overlap without being the same image");
  }
}

void check_views(const ConstPackedView& source, const ConstPackedView& destination) {
  const ConstImageView from = check_packed(source, "source");
  const ConstImageView to = check_packed(destination, "destination");
  check_same_size(source, destination);
  const bool share_bytes = image_bytes(from) > 0 &&
                           ranges_overlap(from.data, image_bytes(from), to.data, image_bytes(to));
  if (share_bytes && !same_image(from, to)) {
    reject("source and destination overlap without being the same image");
  }
}

template <class T>
void check_views(const ConstImageView& source, const View<T>& numbers) {
  constexpr bool is_label = std::is_same_v<T, std::int32_t>;
  check_pair(source, "source", numbers, is_label ? "labels" : "distances");
}

template void check_views(const ConstImageView& source, const LabelView& numbers);
template void check_views(const ConstImageView& source, const View<double>& numbers);

void check_labels(const ConstLabelView& labels) {
  check_view(bytes_of(labels, "labels exceed"), "labels");
}

void check_views(const ConstLabelView& labels, const View<double>& distances) {
  check_pair(labels, "labels", distances, "distances");
}

void check_views(const ConstLabelView& source, const LabelView& destination, InPlace in_place) {
  if (source.width != destination.width || source.height != destination.height) {
    reject("source is " + size_text(source.width, source.height) + " and destination " +
           size_text(destination.width, destination.height) + "; they must have the same size");
  }
  check_views(bytes_of(source, "source exceeds"), bytes_of(destination, "destination exceeds"),
              in_place);
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

void check_stacks(const ConstStackView& source, const ConstStackView& destination) {
  check_stack(source, "source");
  check_stack(destination, "destination");
  if (source.count != destination.count || source.width != destination.width ||
      source.height != destination.height) {
    reject("source is " + text_of(source) + " and destination " + text_of(destination) +
           "; they must have the same count and size");
  }
  if (overlap(source, destination) && !same_stack(source, destination)) {
    reject("source and destination overlap without being the same images");
  }
}

}  // namespace thinbench::detail
