// States whose engine is a cycle of passes over planes of T.
#pragma once

#include <array>

#include "thinning/iteration/iterate.hpp"
#include "thinning/iteration/plane_state.hpp"

namespace thinbench::detail {

/// A row of elements with a 1 for the first and the last pixel of a row of the image, where the
/// border is kept.
template <class T>
class OutermostPixels {
 public:
  OutermostPixels(Index width, Border border) {
    if (border == Border::background || width == 0) return;
    row_ = Plane<T>(width, 1);
    mark(0);
    mark(width - 1);
  }

  /// See Pass; nullptr where all pixels may change.
  [[nodiscard]] const T* row() const { return row_.view().data; }

 private:
  void mark(Index x) {
    constexpr Index pixels = sizeof(T) == 1 ? 1 : kWordBits;
    T& element = row_.view().data[x / pixels];
    element = static_cast<T>(element | T{1} << (x % pixels));
  }

  Plane<T> row_;
};

/// Passes over planes of T, repeated.
template <class T>
class PassState final : public PlaneState<T> {
 public:
  using PlaneState<T>::planes;

  /// The functions of `passes` must live as long as the program.
  PassState(std::span<const Pass<T>> passes, const ThinningSetting& setting)
      : PlaneState<T>(setting),
        passes_(passes),
        rule_(setting.runtime_rule),
        outermost_(setting.width, setting.border),
        repetition_{rule_.get(), setting.max_iterations,
                    changing_rows(setting.height, setting.border), outermost_.row()},
        scratch_(setting.width, setting.height),
        activity_(repetition_.rows, planes.result.view().row_elements,
                  sizeof(T) == 1 ? kWordBits : 1) {}

  int thin() override {
    return iterate<T>(passes_, repetition_, this->source(), planes.result.view(), scratch_.view(),
                      activity_, this->team);
  }

 private:
  std::span<const Pass<T>> passes_;
  std::shared_ptr<const RuntimeRule> rule_;
  OutermostPixels<T> outermost_;
  Repetition<T> repetition_;
  Plane<T> scratch_;
  TileActivity activity_;
};

/// One pass that sees what the last step changed.
class ChangeState final : public PlaneState<std::uint64_t> {
 public:
  ChangeState(ChangePass pass, const ThinningSetting& setting)
      : PlaneState(setting),
        pass_(pass),
        rule_(setting.runtime_rule),
        outermost_(setting.width, setting.border),
        repetition_{rule_.get(), setting.max_iterations,
                    changing_rows(setting.height, setting.border), outermost_.row()},
        scratch_{BitPlane(setting.width, setting.height), BitPlane(setting.width, setting.height)},
        activity_(repetition_.rows, planes.result.view().row_elements, 1) {}

  int thin() override {
    return iterate_changes(pass_, repetition_, source(),
                           {planes.result.view(), scratch_[0].view(), scratch_[1].view()},
                           activity_, team);
  }

 private:
  ChangePass pass_;
  std::shared_ptr<const RuntimeRule> rule_;
  OutermostPixels<std::uint64_t> outermost_;
  Repetition<std::uint64_t> repetition_;
  std::array<BitPlane, 2> scratch_;
  TileActivity activity_;
};

}  // namespace thinbench::detail
