// The states of the operations on objects and holes: a variant with its memory. Each works on
// packed bits, one per pixel.
#pragma once

#include <memory>
#include <span>

#include "core/checks.hpp"
#include "core/packing.hpp"
#include "core/planes.hpp"
#include "core/thread_team.hpp"
#include "core/variant.hpp"
#include "regions/contact_labeller.hpp"
#include "regions/euler.hpp"
#include "regions/hole_filler.hpp"
#include "regions/run_labeller.hpp"
#include "thinbench/regions.hpp"

namespace thinbench::detail {

/// An image as packed bits.
class PackedImage {
 public:
  PackedImage(Isa isa, Index width, Index height)
      : conversion_(plane_conversion<std::uint64_t>(isa)), bits_(width, height) {}

  /// Valid until the next call. `source` must have the size of this.
  ConstBitPlaneView read(const ConstImageView& source) {
    conversion_.read(source, bits_.view());
    return bits_.view();
  }
  /// The same; threads share the rows.
  ConstBitPlaneView read(const ConstImageView& source, const ThreadTeam& team) {
    read_rows(team, conversion_, source, bits_.view());
    return bits_.view();
  }

 private:
  const PlaneConversion<std::uint64_t>& conversion_;
  BitPlane bits_;
};

/// For lists of regions.
struct ListParameters {
  bool with_holes;
};
using ListSetting = Setting<ListParameters>;

/// Lists of objects and, if asked for, holes. Threads share strips of rows.
class ListState {
 public:
  using Parameters = ListParameters;

  static void check(const ListParameters& /*parameters*/, Index width, Index height) {
    require_regions_size(width, height);
  }
  ListState(const RunEngine& engine, const ListSetting& setting)
      : team_(setting.threads),
        image_(setting.isa, setting.width, setting.height),
        labeller_(engine, setting.with_holes, setting.isa, setting.width, setting.height, team_) {}

  void run(const ConstImageView& source, Regions& found) {
    find(image_.read(source, team_), found);
  }
  void find(const ConstBitPlaneView& image, Regions& found) { labeller_.find(image, found); }

 private:
  ThreadTeam team_;
  PackedImage image_;
  RunLabeller labeller_;
};

using LabelSetting = Setting<LabelParameters>;

/// Label images of objects and, if asked for, of holes. Threads share strips of rows.
class LabelState {
 public:
  using Parameters = LabelParameters;

  static void check(const LabelParameters& parameters, Index width, Index height);
  explicit LabelState(const LabelSetting& setting)
      : team_(setting.threads),
        image_(setting.isa, setting.width, setting.height),
        contacts_(setting, setting.isa, setting.width, setting.height, team_) {}

  /// Returns the number of objects; sets the lists that the task has.
  Label run(const ConstImageView& source, const LabelView& labels, Regions& found);

 private:
  ThreadTeam team_;
  PackedImage image_;
  ContactLabeller contacts_;
};

/// The connectivity of objects; that of the background is the other one.
struct EulerParameters {
  Connectivity objects;
};
using EulerSetting = Setting<EulerParameters>;

/// The Euler number. Threads share rows.
class EulerState {
 public:
  using Parameters = EulerParameters;

  static void check(const EulerParameters& /*parameters*/, Index width, Index height) {
    require_regions_size(width, height);
  }
  explicit EulerState(const EulerSetting& setting);

  [[nodiscard]] std::int64_t run(const ConstImageView& source) {
    return count(image_.read(source, team_));
  }
  [[nodiscard]] std::int64_t count(const ConstBitPlaneView& image) const;

 private:
  EulerKernel kernel_;
  PackedImage image_;
  ThreadTeam team_;
};

using FillSetting = Setting<HoleFilling>;

/// Objects with their holes filled.
class FillState {
 public:
  using Parameters = HoleFilling;

  static void check(const HoleFilling& filling, Index width, Index height);
  explicit FillState(const FillSetting& setting);

  void run(const ConstImageView& source, const ImageView& destination) {
    conversion_.write(fill(image_.read(source)), destination);
  }
  /// Valid until the next call.
  ConstBitPlaneView fill(const ConstBitPlaneView& image) {
    filler_.fill(image, filled_.view());
    return filled_.view();
  }

 private:
  const PlaneConversion<std::uint64_t>& conversion_;
  PackedImage image_;
  HoleFiller filler_;
  BitPlane filled_;
};

using ListOperation = Operation<bool, ListState>;  // by with_holes
using LabelOperation = Operation<LabelTask, LabelState>;
using EulerOperation = Operation<Connectivity, EulerState>;
using FillOperation = Operation<Connectivity, FillState>;

// They live as long as the program.
[[nodiscard]] std::span<const ListOperation> list_operations();
[[nodiscard]] std::span<const LabelOperation> label_operations();
[[nodiscard]] std::span<const EulerOperation> euler_operations();
[[nodiscard]] std::span<const FillOperation> fill_operations();

// Throw std::invalid_argument for a value outside the enumeration.
[[nodiscard]] const ListOperation& operation_of(const ListParameters& parameters);
[[nodiscard]] const LabelOperation& operation_of(const LabelParameters& parameters);
[[nodiscard]] const EulerOperation& operation_of(const EulerParameters& parameters);
[[nodiscard]] const FillOperation& operation_of(const HoleFilling& filling);

/// Rejects another connectivity than 4 and 8, and a negative area.
void require_filling(const HoleFilling& filling);

}  // namespace thinbench::detail
