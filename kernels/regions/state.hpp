// The states of the operations on objects and holes: a variant with its memory.
#pragma once

#include <memory>
#include <span>
#include <stdexcept>

#include "core/packing.hpp"
#include "core/planes.hpp"
#include "core/variant.hpp"
#include "regions/label_store.hpp"
#include "thinbench/regions.hpp"

namespace thinbench::detail {

/// What to compute: lists of regions (holes, components), the Euler number with 8- or 4-connected
/// objects, or an image (fill; fill_four with 4-connected objects).
enum class RegionsTask : std::uint8_t {
  holes,
  components,
  euler_eight,
  euler_four,
  fill,
  fill_four
};

struct RegionsParameters {
  RegionsTask task;
  std::int64_t max_area = kAnyHoleArea;  // of holes to fill
};
/// That of the two for this connectivity of objects. Throws std::invalid_argument.
[[nodiscard]] RegionsTask task_for(Connectivity objects, RegionsTask eight, RegionsTask four);
/// Rejects a negative area.
void require_max_area(std::int64_t max_area);

using RegionsSetting = Setting<RegionsParameters>;

/// Owns all memory for images of one size: one bit per pixel for packed images, one byte for `lut`,
/// five bytes for `union_find`. Filling takes another bit or byte per pixel, and where it labels
/// runs, two bits per pixel and 8 bytes per run. Regions take 52 bytes per provisional label (at
/// most one per two pixels; on images of parts one per some thousand). Memory for labels and runs
/// grows on demand: compute() allocates only when an image has more of them than all before.
class RegionsState {
 public:
  using Parameters = RegionsParameters;

  static void check(const RegionsParameters& parameters, Index width, Index height) {
    require_regions_size(width, height);
    require_max_area(parameters.max_area);
  }

  RegionsState() = default;
  virtual ~RegionsState() = default;
  RegionsState(const RegionsState&) = delete;
  RegionsState& operator=(const RegionsState&) = delete;

  /// Packs the image.
  virtual void load(const ConstImageView& source) = 0;
  /// Does not change the loaded image, so it may be repeated.
  virtual void compute() = 0;
  /// The result of the task; the other two functions throw std::logic_error. Lists are valid until
  /// the next compute().
  [[nodiscard]] virtual RegionLists regions() const { throw_other_result(); }
  [[nodiscard]] virtual std::int64_t number() const { throw_other_result(); }
  virtual void store(const ImageView& /*destination*/) const { throw_other_result(); }

 private:
  [[noreturn]] static void throw_other_result() {
    throw std::logic_error("the operation has another kind of result");
  }
};

/// The base of states that work on a plane of T.
template <class T>
class RegionsPlaneState : public RegionsState {
 public:
  explicit RegionsPlaneState(const RegionsSetting& setting)
      : conversion_(plane_conversion<T>(setting.isa)), image_(setting.width, setting.height) {}

  void load(const ConstImageView& source) override { conversion_.read(source, image_.view()); }

 protected:
  [[nodiscard]] ConstPlaneView<T> image() const { return image_.view(); }
  [[nodiscard]] const PlaneConversion<T>& conversion() const { return conversion_; }

 private:
  const PlaneConversion<T>& conversion_;
  Plane<T> image_;
};

using RegionsVariant = Variant<RegionsState>;
using RegionsVariants = VariantList<RegionsState>;
using RegionsOperation = Operation<RegionsTask, RegionsState>;

/// They live as long as the program.
[[nodiscard]] std::span<const RegionsOperation> regions_operations();
[[nodiscard]] const RegionsOperation& operation_of(RegionsTask task);

}  // namespace thinbench::detail
