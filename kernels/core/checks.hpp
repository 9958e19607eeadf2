// Checks of arguments at the public interface, before anything is allocated or written. All throw
// std::invalid_argument.
#pragma once

#include <concepts>
#include <span>
#include <string>

#include "thinbench/distance.hpp"
#include "thinbench/image_view.hpp"
#include "thinbench/packed.hpp"

namespace thinbench::detail {

/// Throws with this message unless the condition holds.
void require(bool condition, const std::string& message);
void require(bool condition, const char* message);
/// The same with a message that is made only if it is needed: for what every call or pixel checks.
template <std::invocable Text>
void require(bool condition, const Text& text) {
  if (!condition) require(false, text());
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

enum class InPlace : bool { rejected, allowed };

/// Rejects a negative size, a stride below the width, a view that exceeds the address space, a null
/// image, or an overlap. The sizes may differ.
void check_disjoint(const ConstImageView& a, const std::string& a_name, const ConstImageView& b,
                    const std::string& b_name);

/// The same, and rejects sizes that differ. `in_place`: whether both may be the same image. Views
/// side by side do not overlap.
void check_views(const ConstImageView& source, const ConstImageView& destination, InPlace in_place);

/// The same for packed images, which may be the same image; views side by side count as
/// overlapping.
void check_views(const ConstPackedView& source, const ConstPackedView& destination);

/// The same for an image of labels or of distances; rejects any overlap.
template <class T>
void check_views(const ConstImageView& source, const View<T>& numbers);
extern template void check_views(const ConstImageView& source, const LabelView& numbers);
extern template void check_views(const ConstImageView& source, const View<double>& numbers);

/// The same for an image of labels, alone, with distances, and with another one.
void check_labels(const ConstLabelView& labels);
void check_views(const ConstLabelView& labels, const View<double>& distances);
void check_views(const ConstLabelView& source, const LabelView& destination, InPlace in_place);

/// The same for lists of images of any sizes, and rejects more than 2^40 pixels and lists of
/// different lengths. Each destination is its source or shares no byte with any image of the lists.
void check_lists(std::span<const ConstImageView> sources, std::span<const ImageView> destinations);

/// Rejects a negative count or size, a row or an image that does not fit its stride, a stack that
/// exceeds the address space or has no data, counts or sizes that differ, or a partial overlap.
/// Stacks with interleaved images in one buffer count as overlapping. Allocates nothing unless it
/// throws.
void check_stacks(const ConstStackView& source, const ConstStackView& destination);

}  // namespace thinbench::detail
