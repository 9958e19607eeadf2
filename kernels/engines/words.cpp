// The word scan: double-buffered planes, in bands of rows that threads share. For images of any
// width, and for rules that add pixels.
#include <utility>

#include "engines/iterate.hpp"
#include "engines/plane_state.hpp"
#include "engines/variants.hpp"

namespace thinbench::detail {
namespace {

/// Applies sub-iteration `sub` to the active columns of a band.
std::uint64_t scan_band(const BoundRule& rule, int sub, const std::uint64_t* fixed,
                        const ConstBitPlaneView& source, const BitPlaneView& target,
                        const Band& band) {
  constexpr auto bytes = static_cast<Index>(sizeof(std::uint64_t));
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

class WordState final : public PlaneState<std::uint64_t> {
 public:
  WordState(BoundRule rule, const ThinningSetting& setting)
      : PlaneState(setting),
        rule_(std::move(rule)),
        plan_{static_cast<int>(rule_.sub_iterations), setting.max_iterations,
              changing_rows(setting.height, setting.border)},
        activity_(plan_.rows, planes.result.view().row_elements, 1),
        fixed_(fixed_pixels<std::uint64_t>(setting.width, setting.border, rule_.adds_pixels)),
        scratch_(setting.width, setting.height) {}

  int compute() override {
    const std::uint64_t* const fixed = fixed_.view().data;
    return iterate<std::uint64_t>(
        plan_, {source(), planes.result.view(), scratch_.view()}, activity_, team,
        [&](int sub, const ConstBitPlaneView& from, const BitPlaneView& to, const Band& band) {
          return scan_band(rule_, sub, fixed, from, to, band);
        });
  }

 private:
  BoundRule rule_;
  IterationPlan plan_;
  BandActivity activity_;
  BitPlane fixed_;
  BitPlane scratch_;
};

}  // namespace

std::unique_ptr<ThinningState> make_words(const ThinningSetting& setting) {
  return std::make_unique<WordState>(
      bind(setting.rule, setting.isa, Layout::words, has_fixed_pixels(setting)), setting);
}

std::unique_ptr<ThinningState> make_words(BoundRule rule, const ThinningSetting& setting) {
  return std::make_unique<WordState>(std::move(rule), setting);
}

}  // namespace thinbench::detail
