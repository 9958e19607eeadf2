// States of passes.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "engines/iterate.hpp"
#include "engines/plane_state.hpp"
#include "techniques/net_model.hpp"
#include "techniques/passes.hpp"

namespace thinbench::detail {

[[nodiscard]] inline IterationPlan iteration_plan(std::size_t passes,
                                                  const ThinningSetting& setting) {
  return {static_cast<int>(passes), setting.max_iterations,
          changing_rows(setting.height, setting.border)};
}

/// Iterates passes over planes of T.
template <class T>
class PassState final : public PlaneState<T> {
 public:
  using PlaneState<T>::planes;

  /// `passes` must refer to static storage.
  PassState(std::span<const Pass<T>> passes, const ThinningSetting& setting)
      : PlaneState<T>(setting),
        passes_(passes),
        plan_(iteration_plan(passes.size(), setting)),
        activity_(plan_.rows, planes.result.view().row_elements, sizeof(T) == 1 ? kWordBits : 1),
        fixed_(fixed_pixels<T>(setting.width, setting.border, false)),
        scratch_(setting.width, setting.height) {}

  int compute() override {
    const T* const fixed = fixed_.view().data;
    return iterate<T>(
        plan_, {this->source(), planes.result.view(), scratch_.view()}, activity_, this->team,
        [&](int sub, const ConstPlaneView<T>& from, const PlaneView<T>& to, const Band& band) {
          return passes_[static_cast<std::size_t>(sub)](fixed, from, to, band);
        });
  }

 private:
  std::span<const Pass<T>> passes_;
  IterationPlan plan_;
  BandActivity activity_;
  Plane<T> fixed_;
  Plane<T> scratch_;
};

/// Iterates the pass of a net, which the rule keeps alive.
class NetState final : public PlaneState<std::uint64_t> {
 public:
  NetState(NetPass pass, const NetModel& net, const ThinningSetting& setting)
      : PlaneState(setting),
        rule_(setting.rule),
        net_(net),
        pass_(pass),
        plan_(iteration_plan(1, setting)),
        activity_(plan_.rows, planes.result.view().row_elements, 1),
        fixed_(fixed_pixels<std::uint64_t>(setting.width, setting.border, false)),
        scratch_{BitPlane(setting.width, setting.height), BitPlane(setting.width, setting.height)} {
  }

  int compute() override {
    // The target holds the image of three iterations ago: a cell may be skipped only after two
    // iterations without changes.
    constexpr int lookback = 2;
    const std::array<BitPlaneView, 3> buffers = {planes.result.view(), scratch_[0].view(),
                                                 scratch_[1].view()};
    activity_.restart();
    const BitPlaneView& background = buffers[2];
    for (Index y = 0; y < background.height; ++y) {
      std::fill_n(background.row(y), background.row_elements, 0);
    }
    for (const BitPlaneView& plane : buffers) copy_fixed_rows(plan_.rows, source(), plane);
    const std::uint64_t* const fixed = fixed_.view().data;
    ConstBitPlaneView previous = background;
    ConstBitPlaneView current = source();
    int iterations = 0;
    for (bool changed = true; changed && iterations < plan_.max_iterations; ++iterations) {
      const BitPlaneView& next = buffers[static_cast<std::size_t>(iterations) % buffers.size()];
      changed = activity_.run_sub_iteration(lookback, team, [&](const Band& band) {
        return pass_(net_, fixed, previous, current, next, band);
      });
      previous = std::exchange(current, next);
    }
    if (current.data != buffers[0].data) copy_rows(current, buffers[0], {0, current.height});
    return iterations;
  }

 private:
  SharedRule rule_;
  const NetModel& net_;
  NetPass pass_;
  IterationPlan plan_;
  BandActivity activity_;
  BitPlane fixed_;
  std::array<BitPlane, 2> scratch_;
};

}  // namespace thinbench::detail
