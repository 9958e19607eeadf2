// One variant of the operations on objects and holes at work.
#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string_view>

#include "dispatch/variant.hpp"
#include "regions/label_store.hpp"

namespace thinbench::detail {

/// What is asked for: lists of regions (holes, components), a number (the Euler number with 8- or
/// 4-connected objects) or an image (interior contours filled).
enum class RegionsTask : std::uint8_t { holes, components, euler_eight, euler_four, fill };

/// What a state needs to know beside its technique.
struct RegionsSetting {
  RegionsTask task;
  Isa isa;
  Index width;
  Index height;
  int threads;
};

/// Owns all memory that images of one size need: one bit per pixel for packed images, one byte for
/// `lut`, five bytes for `union_find`; filling takes one bit or byte per pixel more, and from packed
/// images 8 bytes for each run. Regions take 52 bytes for each provisional label (at most one in two
/// pixels, one in some thousand on pictures of parts). Labels and runs grow by need: an image with
/// more of them than any before makes compute() allocate, a second run on it does not.
///
/// load() packs the image; compute() leaves it as it is, so that it may be repeated.
class RegionsState {
 public:
  using Setting = RegionsSetting;

  RegionsState() = default;
  virtual ~RegionsState() = default;
  RegionsState(const RegionsState&) = delete;
  RegionsState& operator=(const RegionsState&) = delete;
  RegionsState(RegionsState&&) = delete;
  RegionsState& operator=(RegionsState&&) = delete;

  virtual void load(const ConstImageView& source) = 0;
  virtual void compute() = 0;
  /// What the task asked for; the two others throw std::logic_error. Lists are valid until the next
  /// compute().
  [[nodiscard]] virtual RegionLists regions() const { refuse_result(); }
  [[nodiscard]] virtual std::int64_t number() const { refuse_result(); }
  virtual void store(const ImageView& /*destination*/) const { refuse_result(); }

 private:
  [[noreturn]] static void refuse_result() {
    throw std::logic_error("the operation gives another kind of result");
  }
};

using RegionsVariant = Variant<RegionsState>;
using RegionsVariants = VariantList<RegionsState>;

/// The largest width and height: keys of boundaries are 32-bit numbers.
inline constexpr Index kMaxRegionsSide = Index{1} << 29;
/// The most pixels: labels are 32-bit numbers, sums of coordinates 64-bit ones.
inline constexpr Index kMaxRegionsPixels = Index{1} << 32;

}  // namespace thinbench::detail
