#include "techniques/pass_state.hpp"

namespace thinbench::detail {

ChangeState::ChangeState(ChangePass pass, const ThinningSetting& setting,
                         std::shared_ptr<const TableRule> table)
    : PlaneState(setting),
      pass_(pass),
      table_(std::move(table)),
      plan_(iteration_plan(1, setting)),
      activity_(plan_.rows, planes.result.view().row_elements, 1),
      fixed_(fixed_pixels<std::uint64_t>(setting.width, setting.border, false)),
      scratch_{BitPlane(setting.width, setting.height), BitPlane(setting.width, setting.height)} {}

int ChangeState::compute() {
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
      return pass_(table_.get(), fixed, previous, current, next, band);
    });
    previous = std::exchange(current, next);
  }
  if (current.data != buffers[0].data) copy_rows(current, buffers[0], {0, current.height});
  return iterations;
}

}  // namespace thinbench::detail
