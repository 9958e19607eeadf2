// The states of the operations that make label images: a variant with its memory.
#pragma once

#include <memory>
#include <span>

#include "core/checks.hpp"
#include "core/packing.hpp"
#include "core/planes.hpp"
#include "core/variant.hpp"
#include "regions/label_store.hpp"
#include "thinbench/enumeration.hpp"
#include "thinbench/regions.hpp"

namespace thinbench::detail {

/// Labels alone, labels with the list of objects, and labels of objects and holes with both lists.
enum class LabelsTask : std::uint8_t {
  image_eight,
  image_four,
  components_eight,
  components_four,
  regions
};

struct LabelsParameters {
  LabelsTask task;
  LabelOrder order = LabelOrder::pixels;  // of objects, in tasks without holes
};
using LabelsSetting = Setting<LabelsParameters>;

/// The task of label_components() and, without the list, label_image(). Throws
/// std::invalid_argument.
[[nodiscard]] LabelsTask labels_task(Connectivity connectivity, bool with_list);

[[nodiscard]] constexpr bool is_four_connected(LabelsTask task) {
  return task == LabelsTask::image_four || task == LabelsTask::components_four;
}
[[nodiscard]] constexpr bool has_list(LabelsTask task) {
  return task != LabelsTask::image_eight && task != LabelsTask::image_four;
}

/// Owns all memory for images of one size, besides the labels: a bit per pixel, and memory for runs
/// and regions that grows on demand.
class LabelsState {
 public:
  using Parameters = LabelsParameters;

  static void check(const LabelsParameters& parameters, Index width, Index height) {
    require_enumerator(parameters.order, 2, "order");
    require_label_size(width, height);
  }

  explicit LabelsState(const LabelsSetting& setting)
      : conversion_(plane_conversion<std::uint64_t>(setting.isa)),
        image_(setting.width, setting.height) {}
  virtual ~LabelsState() = default;
  LabelsState(const LabelsState&) = delete;
  LabelsState& operator=(const LabelsState&) = delete;

  /// Both views must have the size of the setting.
  void run(const ConstImageView& source, const LabelView& labels);

  /// Empty for tasks without a list. Valid until the next compute().
  [[nodiscard]] virtual RegionLists regions() const = 0;
  /// The number of objects.
  [[nodiscard]] virtual Label objects() const = 0;

 protected:
  [[nodiscard]] ConstBitPlaneView image() const { return image_.view(); }

  // The steps of run(), for images with pixels.
  /// Packs the image.
  virtual void load(const ConstImageView& source) { conversion_.read(source, image_.view()); }
  /// Finds the objects, and the holes if the task has them.
  virtual void compute() = 0;
  virtual void store(const LabelView& labels) = 0;

 private:
  const PlaneConversion<std::uint64_t>& conversion_;
  BitPlane image_;
};

using LabelsVariant = Variant<LabelsState>;
using LabelsVariants = VariantList<LabelsState>;
using LabelsOperation = Operation<LabelsTask, LabelsState>;

/// They live as long as the program.
[[nodiscard]] std::span<const LabelsOperation> labels_operations();
[[nodiscard]] const LabelsOperation& operation_of(LabelsTask task);

}  // namespace thinbench::detail
