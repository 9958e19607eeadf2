// States that iterate passes over planes of T.
#pragma once

#include <array>

#include "thinning/iteration/iterate.hpp"
#include "thinning/iteration/plane_state.hpp"

namespace thinbench::detail {

/// Owns the parameters of iterate().
template <class T>
class RepetitionMemory {
 public:
  RepetitionMemory(const ThinningSetting& setting, Index row_elements)
      : rule_(setting.runtime_rule),
        repetition_{rule_.get(), setting.max_iterations,
                    changing_rows(setting.height, setting.border), nullptr},
        activity_(repetition_.rows, row_elements, sizeof(T) == 1 ? kWordBits : 1) {
    const bool adds_pixels = rule_ != nullptr && rule_->adds_pixels;
    if ((setting.border == Border::keep || adds_pixels) && setting.width > 0) {
      make_fixed(setting.width, setting.border == Border::keep, adds_pixels);
    }
  }

  [[nodiscard]] const Repetition<T>& repetition() const { return repetition_; }
  [[nodiscard]] BandActivity& activity() { return activity_; }

 private:
  /// Fixes the first and the last column, and the padding, which rules that add pixels would
  /// change.
  void make_fixed(Index width, bool border, bool padding) {
    fixed_ = Plane<T>(width, 1);
    T* const row = fixed_.view().data;
    constexpr Index pixels = sizeof(T) == 1 ? 1 : kWordBits;
    const auto fix = [&](Index x) {
      row[x / pixels] = static_cast<T>(row[x / pixels] | T{1} << (x % pixels));
    };
    if (border) fix(0);
    if (border) fix(width - 1);
    const Index end = fixed_.view().row_elements * pixels;
    for (Index x = width; padding && x < end; ++x) fix(x);
    repetition_.fixed = row;
  }

  std::shared_ptr<const RuntimeRule> rule_;
  Repetition<T> repetition_;
  BandActivity activity_;
  Plane<T> fixed_;
};

/// Iterates the passes of a rule.
template <class T>
class PassState final : public PlaneState<T> {
 public:
  using PlaneState<T>::planes;

  /// `passes` must refer to static storage.
  PassState(std::span<const Pass<T>> passes, const ThinningSetting& setting)
      : PlaneState<T>(setting),
        passes_(passes),
        memory_(setting, planes.result.view().row_elements),
        scratch_(setting.width, setting.height) {}

  int thin() override {
    return iterate<T>(passes_, memory_.repetition(), this->source(), planes.result.view(),
                      scratch_.view(), memory_.activity(), this->team);
  }

 private:
  std::span<const Pass<T>> passes_;
  RepetitionMemory<T> memory_;
  Plane<T> scratch_;
};

/// Iterates a ChangePass.
class ChangeState final : public PlaneState<std::uint64_t> {
 public:
  ChangeState(ChangePass pass, const ThinningSetting& setting)
      : PlaneState(setting),
        pass_(pass),
        memory_(setting, planes.result.view().row_elements),
        scratch_{BitPlane(setting.width, setting.height), BitPlane(setting.width, setting.height)} {
  }

  int thin() override {
    return iterate_changes(pass_, memory_.repetition(), source(),
                           {planes.result.view(), scratch_[0].view(), scratch_[1].view()},
                           memory_.activity(), team);
  }

 private:
  ChangePass pass_;
  RepetitionMemory<std::uint64_t> memory_;
  std::array<BitPlane, 2> scratch_;
};

}  // namespace thinbench::detail
