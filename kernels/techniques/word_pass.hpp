// The word scan as a Pass: columns of words, compiled into one function.
#pragma once

#include "scan/scans.hpp"
#include "techniques/passes.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

template <class Word>
struct WordPass {
  using Element = typename WordTraits<Word>::Element;

  template <class Rule, int sub>
  static std::uint64_t pass(const Element* fixed, const ConstPlaneView<Element>& source,
                            const PlaneView<Element>& target, const Band& band) {
    if (fixed == nullptr) {
      return columns<Rule, sub>(source, target, band, [](Index) { return NoFixedPixels{}; });
    }
    return columns<Rule, sub>(source, target, band, [fixed](Index x) {
      return FixedPixels<Word>{WordTraits<Word>::load(fixed + x)};
    });
  }

 private:
  /// Takes views by value: the compiler would otherwise assume that stores alias their fields.
  template <class Rule, int sub, class FixedAt>
  [[gnu::always_inline]] static std::uint64_t columns(ConstPlaneView<Element> source,
                                                      PlaneView<Element> target, Band band,
                                                      const FixedAt& fixed_at) {
    constexpr Index elements = WordTraits<Word>::kElements;
    constexpr auto bytes = static_cast<Index>(sizeof(Element));
    const Index rows = band.last - band.first;
    std::uint64_t changed = 0;
    for (Index x = 0; x < source.row_elements; x += elements) {
      const std::uint64_t active = band.columns & band.columns_of(x, x + elements);
      if (active == 0) continue;
      const ColumnScan scan = {source.row(band.first) + x,
                               source.stride * bytes,
                               target.row(band.first) + x,
                               target.stride * bytes,
                               rows,
                               rows,
                               nullptr};
      NoPrefetch none;
      if (scan_bands<Rule, sub, PlaneRows<Word>>(scan, fixed_at(x), none) != 0) changed |= active;
    }
    return changed;
  }
};

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
