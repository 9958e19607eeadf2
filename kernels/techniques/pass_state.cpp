#include "techniques/pass_state.hpp"

#include <utility>

namespace thinbench::detail {
namespace {

IterationPlan plan_of(std::size_t passes, const ThinningSetting& setting) {
  return {static_cast<int>(passes), setting.max_iterations,
          changing_rows(setting.height, setting.border)};
}

}  // namespace

PassState::PassState(std::span<const BytePass> passes, const ThinningSetting& setting,
                     std::shared_ptr<const TableRule> table)
    : PlaneState(setting),
      passes_(passes),
      table_(std::move(table)),
      plan_(plan_of(passes.size(), setting)),
      activity_(plan_.rows, planes.result.view().row_elements, kWordBits),
      fixed_(fixed_pixels<std::uint8_t>(setting.width, setting.border, false)),
      scratch_(setting.width, setting.height) {}

int PassState::compute() {
  const std::uint8_t* const fixed = fixed_.view().data;
  return iterate<std::uint8_t>(
      plan_, {source(), planes.result.view(), scratch_.view()}, activity_, team,
      [&](int sub, const ConstBytePlaneView& from, const BytePlaneView& to, const Band& band) {
        return passes_[static_cast<std::size_t>(sub)](table_.get(), fixed, from, to, band);
      });
}

ChangeState::ChangeState(ChangePass pass, const ThinningSetting& setting,
                         std::shared_ptr<const TableRule> table)
    : PlaneState(setting),
      pass_(pass),
      table_(std::move(table)),
      plan_(plan_of(1, setting)),
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
