// States of passes.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <utility>

#include "engines/iterate.hpp"
#include "engines/plane_state.hpp"
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

  /// `passes` must refer to static storage. `table`: see Pass.
  PassState(std::span<const Pass<T>> passes, const ThinningSetting& setting,
            std::shared_ptr<const TableRule> table = nullptr)
      : PlaneState<T>(setting),
        passes_(passes),
        table_(std::move(table)),
        plan_(iteration_plan(passes.size(), setting)),
        activity_(plan_.rows, planes.result.view().row_elements, sizeof(T) == 1 ? kWordBits : 1),
        fixed_(fixed_pixels<T>(setting.width, setting.border, false)),
        scratch_(setting.width, setting.height) {}

  int compute() override {
    const T* const fixed = fixed_.view().data;
    return iterate<T>(
        plan_, {this->source(), planes.result.view(), scratch_.view()}, activity_, this->team,
        [&](int sub, const ConstPlaneView<T>& from, const PlaneView<T>& to, const Band& band) {
          return passes_[static_cast<std::size_t>(sub)](table_.get(), fixed, from, to, band);
        });
  }

 private:
  std::span<const Pass<T>> passes_;
  std::shared_ptr<const TableRule> table_;
  IterationPlan plan_;
  BandActivity activity_;
  Plane<T> fixed_;
  Plane<T> scratch_;
};

/// Iterates a ChangePass.
class ChangeState final : public PlaneState<std::uint64_t> {
 public:
  ChangeState(ChangePass pass, const ThinningSetting& setting,
              std::shared_ptr<const TableRule> table);

  int compute() override;

 private:
  ChangePass pass_;
  std::shared_ptr<const TableRule> table_;
  IterationPlan plan_;
  BandActivity activity_;
  BitPlane fixed_;
  std::array<BitPlane, 2> scratch_;
};

}  // namespace thinbench::detail
