// The word scan: double-buffered planes, in bands of rows that threads share. For images of any
// width, and for rules that add pixels.
#pragma once

#include <utility>

#include "engines/iterate.hpp"
#include "engines/plane_state.hpp"

namespace thinbench::detail {

/// Applies sub-iteration `sub` to the active columns of a band.
template <class T>
std::uint64_t scan_band(const BoundRule& rule, int sub, const T* fixed,
                        const ConstPlaneView<T>& source, const PlaneView<T>& target,
                        const Band& band) {
  constexpr auto bytes = static_cast<Index>(sizeof(T));
  const BoundScan& scan = rule.scans[static_cast<std::size_t>(sub)];
  const Index rows = band.last - band.first;
  std::uint64_t changed = 0;
  for (Index x = 0; x < source.row_elements; x += rule.register_elements) {
    const std::uint64_t columns = band.columns & band.columns_of(x, x + rule.register_elements);
    if (columns == 0) continue;
    const std::uint64_t any = scan({.source = source.row(band.first) + x,
                                    .source_stride = source.stride * bytes,
                                    .target = target.row(band.first) + x,
                                    .target_stride = target.stride * bytes,
                                    .rows = rows,
                                    .band_rows = rows,
                                    .fixed = fixed == nullptr ? nullptr : fixed + x});
    if (any != 0) changed |= columns;
  }
  return changed;
}

/// Applies a rule, bound to Layout::words. T = std::uint8_t: to lanes of bytes.
template <class T>
class ScanState final : public PlaneState<T> {
 public:
  using PlaneState<T>::planes;

  ScanState(BoundRule rule, const ThinningSetting& setting)
      : PlaneState<T>(setting),
        rule_(std::move(rule)),
        plan_{static_cast<int>(rule_.sub_iterations), setting.max_iterations,
              changing_rows(setting.height, setting.border)},
        activity_(plan_.rows, planes.result.view().row_elements, sizeof(T) == 1 ? kWordBits : 1),
        fixed_(fixed_pixels<T>(setting.width, setting.border, rule_.adds_pixels)),
        scratch_(setting.width, setting.height) {}

  int compute() override {
    const T* const fixed = fixed_.view().data;
    return iterate<T>(
        plan_, {this->source(), planes.result.view(), scratch_.view()}, activity_, this->team,
        [&](int sub, const ConstPlaneView<T>& from, const PlaneView<T>& to, const Band& band) {
          return scan_band(rule_, sub, fixed, from, to, band);
        });
  }

 private:
  BoundRule rule_;
  IterationPlan plan_;
  BandActivity activity_;
  Plane<T> fixed_;
  Plane<T> scratch_;
};

}  // namespace thinbench::detail
