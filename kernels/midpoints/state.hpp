// The state of the midpoint scan.
#pragma once

#include <memory>
#include <utility>
#include <variant>

#include "core/variant.hpp"
#include "engines/plane_state.hpp"
#include "midpoints/border.hpp"
#include "midpoints/work.hpp"

namespace thinbench::detail {

struct MidpointParameters {
  Directions directions;
  Border border;
};
using MidpointSetting = Setting<MidpointParameters>;

/// Like ThinningState.
class MidpointState {
 public:
  using Parameters = MidpointParameters;

  /// Rejects bits of no direction, and Border::foreground.
  static void check(const MidpointParameters& parameters, Index width, Index height);

  MidpointState() = default;
  virtual ~MidpointState() = default;
  MidpointState(const MidpointState&) = delete;
  MidpointState& operator=(const MidpointState&) = delete;

  virtual void run(const ConstImageView& source, const ImageView& destination) = 0;
};

using MidpointOperation = Operation<std::monostate, MidpointState>;

[[nodiscard]] const MidpointOperation& midpoint_operation();

/// On planes of T; derived classes implement mark() with the same threads.
template <class T>
class MidpointPlanes : public MidpointState {
 public:
  explicit MidpointPlanes(const MidpointSetting& setting)
      : planes(setting.isa, setting.width, setting.height),
        bands(setting.width, setting.height, setting.threads),
        border_(setting.border) {}

  void run(const ConstImageView& source, const ImageView& destination) final {
    read_planes(bands, source, planes);
    mark();
    apply_border<T>(border_, planes.source.view(), planes.result.view());
    write_planes(bands, planes, destination);
  }

 protected:
  /// Writes all of the result plane.
  virtual void mark() = 0;

  Planes<T> planes;
  BandTeam bands;

 private:
  Border border_;
};

/// The state of one compilation of the scan.
[[nodiscard]] std::unique_ptr<MidpointState> make_midpoint_scan(const ScanKernels& kernels,
                                                                const MidpointSetting& setting);

}  // namespace thinbench::detail
